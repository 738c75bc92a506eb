// The tree of shapes against the loop over all shapes: not one bit may differ.
#include "render/accel/shape_tree.h"

#include <gtest/gtest.h>

#include "unit/render/accel/paths.h"

namespace alhazen::render {
namespace {

template <class Real>
class ShapeTreeOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ShapeTreeOf, Precisions);

template <class Real>
std::vector<int> binary_scales() {
  if constexpr (std::is_same_v<Real, float>) return {-20, 0, 20};
  return {-300, 0, 300};
}

// All kinds, with and without transforms, over sizes of six decades; rays from everywhere.
TYPED_TEST(ShapeTreeOf, RandomScenes) {
  using Real = TypeParam;
  int hits = 0;
  for (const int k : binary_scales<Real>()) {
    const double scale = std::ldexp(1.0, k);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const ShapeTable<Real> table(mixed_shapes(seed, scale, 40), Vec3d{});
      const ShapeTree<Real> tree(table);
      Dice dice(seed + 500);
      for (int i = 0; i < 300; ++i) {
        const Ray<Real> ray = random_ray<Real>(dice, scale);
        hits += compare_path(table, tree, ray, dice, 3);
        ASSERT_FALSE(this->HasFailure()) << "2^" << k << " seed " << seed << " ray " << i;
      }
    }
  }
  EXPECT_GT(hits, 5000);
}

// Abutting boxes, one box many times, spheres at one place: hits at one t, ordered by rule. Rays
// along axes, in the planes of faces, through edges and corners.
TYPED_TEST(ShapeTreeOf, CoincidentShapes) {
  using Real = TypeParam;
  int hits = 0;
  for (const int k : binary_scales<Real>()) {
    const double scale = std::ldexp(1.0, k);
    const ShapeTable<Real> table(coincident_shapes(scale), Vec3d{});
    const ShapeTree<Real> tree(table);
    EXPECT_EQ(tree.outside().size(), 0u);
    Dice dice(7);
    for (int i = 0; i < 3000; ++i) {
      const Ray<Real> ray = lattice_ray<Real>(dice, scale);
      hits += compare_path(table, tree, ray, dice, 4);
      ASSERT_FALSE(this->HasFailure()) << "2^" << k << " ray " << i;
    }
  }
  EXPECT_GT(hits, 5000);
}

// Rays that graze spheres, cylinders and cones, from near and from 10^8 times the scene.
TYPED_TEST(ShapeTreeOf, GrazingAndFarRays) {
  using Real = TypeParam;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const ShapeTable<Real> table(mixed_shapes(seed, 1, 40), Vec3d{});
    const ShapeTree<Real> tree(table);
    Dice dice(seed + 900);
    for (const double distance : {3.0, 1e3, 1e8}) {
      for (int i = 0; i < 200; ++i) {
        const auto id = static_cast<ShapeId>(dice.below(static_cast<int>(table.size())));
        const auto bounds = table.bounds(id);
        if (!bounds) continue;
        const Ray<Real> ray = grazing_ray(dice, *bounds, distance);
        hits += compare_path(table, tree, ray, dice, 2);
        ASSERT_FALSE(this->HasFailure()) << "seed " << seed << " from " << distance << " ray " << i;
      }
    }
  }
  EXPECT_GT(hits, 800);
}

// Rays along the lines of cones, where the equation of the side all but loses its square.
TYPED_TEST(ShapeTreeOf, RaysAlongConesAndCylinders) {
  using Real = TypeParam;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed + 1300);
    std::vector<Shape> shapes;
    std::vector<Cone> cones;
    for (int i = 0; i < 20; ++i) {
      const Vec3d base = dice.in_cube(3);
      cones.push_back({base, base + dice.uniform(0.2, 3) * dice.direction(), dice.uniform(0.1, 1),
                       i % 3 == 0 ? 0.0 : dice.uniform(0, 0.5), i % 2 == 0});
      shapes.push_back(shape_of(cones.back()));
    }
    const ShapeTable<Real> table(shapes, Vec3d{});
    const ShapeTree<Real> tree(table);
    for (int i = 0; i < 60; ++i) {
      const Cone& cone = cones[static_cast<std::size_t>(dice.below(20))];
      const Ray<Real> ray = ray_along_side<Real>(dice, cone);
      hits += compare_path(table, tree, ray, dice, 2);
      ASSERT_FALSE(this->HasFailure()) << "seed " << seed << " ray " << i;
    }
  }
  EXPECT_GT(hits, 2000);
}

// Directions and origins that leave the ordinary range, or have parts that do.
TEST(ShapeTree, ExtremeDirections) {
  const ShapeTable<double> table(mixed_shapes(3, 1, 40), Vec3d{});
  const ShapeTree<double> tree(table);
  Dice dice(77);
  for (int i = 0; i < 4000; ++i) {
    Ray<double> ray = random_ray<double>(dice, 1);
    const double factors[] = {0.0, -0.0, 1, 0x1p-1060, -0x1p-1070, 0x1p-600, 0x1p500};
    for (int axis = 0; axis < 3; ++axis)
      ray.direction[axis] *= factors[dice.below(7)];
    if (ray.direction == Vec3d()) continue;
    expect_same(closest_hit(tree, ray, Source(), infinity<double>()),
                closest_hit(table, ray, Source(), infinity<double>()));
    ASSERT_FALSE(HasFailure()) << i;
  }
}

#if ALHAZEN_HAS_QUAD
TEST(ShapeTree, QuadIsTheSameToo) {
  const ShapeTable<Quad> table(mixed_shapes(5, 1, 40), Vec3d{});
  const ShapeTree<Quad> tree(table);
  Dice dice(78);
  int hits = 0;
  for (int i = 0; i < 100; ++i)
    hits += compare_path(table, tree, random_ray<Quad>(dice, 1), dice, 3);
  EXPECT_GT(hits, 30);
}
#endif

TEST(ShapeTree, EmptyAndAllOutside) {
  const Ray<double> ray{{0, 0, 0}, {0, -1, 0}};
  const ShapeTable<double> nothing({}, Vec3d{});
  EXPECT_FALSE(closest_hit(ShapeTree<double>(nothing), ray, Source(), 9.0).has_value());
  const ShapeTable<double> ground({shape_of(alhazen::Plane{{0, 1, 0}, -1})}, Vec3d{});
  const ShapeTree<double> tree(ground);
  EXPECT_EQ(tree.outside().size(), 1u);
  EXPECT_TRUE(any_hit(tree, ray, Source(), 9.0));
}

// A hundred thousand spheres at one place, and a thousand that shrink towards a point, where the
// SAH would cut off one at a time.
TEST(ShapeTree, BoundedDepthHoweverShapesLie) {
  std::vector<Shape> shapes(100000, shape_of(alhazen::Sphere{{1, 2, 3}, 1}));
  double size = 1;
  for (int i = 0; i < 1000; ++i, size *= 0.75)  // each a quarter smaller, towards one point
    shapes.push_back(shape_of(alhazen::Sphere{{size, 0, 0}, 0.1 * size}));
  const ShapeTable<double> table(shapes, Vec3d{});
  const ShapeTree<double> tree(table);
  // At worst the lowest nodes have two children and all others four: 2/3 of a node a shape.
  EXPECT_LE(tree.bytes(), (2 * sizeof(TreeNode) / 3 + sizeof(ShapeId) + 1) * shapes.size());
  const Ray<double> ray{{-1, 0, 0}, {1, 0, 0}};
  expect_same(closest_hit(tree, ray, Source(), infinity<double>()),
              closest_hit(table, ray, Source(), infinity<double>()));
}

// What the boxes promise: the place of each hit, computed in a wider type, lies within.
template <class Real, class Wide>
void check_bounds(int scale_exponent) {
  const double scale = std::ldexp(1.0, scale_exponent);
  std::vector<int> seen(64);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const ShapeTable<Real> table(mixed_shapes(seed, scale, 3), Vec3d{});
    Dice dice(seed + 2000);
    for (ShapeId id = 0; id < table.size(); ++id) {
      const auto bounds = table.bounds(id);
      if (!bounds || !is_finite(bounds->reach)) continue;
      for (int i = 0; i < 100; ++i) {
        const double far = i % 4 == 0 ? 1e6 : i % 4 == 1 ? 1e3 : 4;
        const Ray<Real> ray = grazing_ray(dice, *bounds, far * scale);
        const Real margin = bounds->reach * largest_coordinate(ray.origin);
        for (const auto& crossing : table.crossings(id, ray, Departure())) {
          ++seen[id % 64];
          for (int axis = 0; axis < 3; ++axis) {
            const Wide place =
                Wide(ray.origin[axis]) + Wide(crossing.t) * Wide(ray.direction[axis]);
            ASSERT_GE(place, Wide(bounds->min[axis]) - Wide(margin)) << id << ' ' << seed;
            ASSERT_LE(place, Wide(bounds->max[axis]) + Wide(margin)) << id << ' ' << seed;
          }
        }
      }
    }
  }
  for (ShapeId kind = 0; kind < 7; ++kind)
    EXPECT_GT(seen[kind], 0) << kind;
}

TEST(ShapeBounds, HoldEveryHitInFloat) {
  check_bounds<float, double>(0);
}
TEST(ShapeBounds, HoldEveryHitInDouble) {
  for (const int k : {-300, 0, 300})
    check_bounds<double, long double>(k);
}

}  // namespace
}  // namespace alhazen::render
