// Packets of rays through the tree against the loop over all shapes, ray by ray: not one bit may
// differ, in whatever company a ray goes.
#include <gtest/gtest.h>

#include "unit/render/accel/packets.h"

namespace alhazen::render {
namespace {

template <class L>
class Packets : public testing::Test {};
using Widths = testing::Types<Lanes<float, 4>, Lanes<float, 8>, Lanes<float, 16>, Lanes<double, 2>,
                              Lanes<double, 4>, Lanes<double, 8>, Lanes<double, 16>>;
TYPED_TEST_SUITE(Packets, Widths);

TYPED_TEST(Packets, RandomScenes) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const double scale = std::ldexp(1.0, static_cast<int>(seed % 3) * 20 - 20);
    const ShapeTable<Real> table(mixed_shapes(seed, scale, seed < 4 ? 2 : 25), Vec3d{});
    const ShapeTree<Real> tree(table);
    Dice dice(seed + 3000);
    for (int i = 0; i < 60; ++i) {
      Rays<L> rays = narrow_rays<L>(dice, scale);
      if (i % 3 == 0) {
        for (auto& ray : rays.ray)
          ray = random_ray<Real>(dice, scale);
      }
      hits += compare_paths(table, tree, rays, dice, 3);
      ASSERT_FALSE(this->HasFailure()) << "seed " << seed << " packet " << i;
    }
  }
  EXPECT_GT(hits, 100 * L::kWidth);
}

// Hits at one t and at t = 0, in the planes of faces and through corners.
TYPED_TEST(Packets, CoincidentShapes) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  const ShapeTable<Real> table(coincident_shapes(1), Vec3d{});
  const ShapeTree<Real> tree(table);
  Dice dice(8);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    Rays<L> rays;
    for (auto& ray : rays.ray)
      ray = lattice_ray<Real>(dice, 1);
    if (i % 2 == 0) {  // side by side
      for (auto& ray : rays.ray)
        ray = {rays.ray[0].origin + Vec3<Real>(dice.in_cube(0.01)), rays.ray[0].direction};
    }
    hits += compare_paths(table, tree, rays, dice, 4);
    ASSERT_FALSE(this->HasFailure()) << i;
  }
  EXPECT_GT(hits, 100 * L::kWidth);
}

// Grazing from near and far, and beyond what the tree's error bounds speak of.
TYPED_TEST(Packets, GrazingFarAndExtremeRays) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  const ShapeTable<Real> table(mixed_shapes(4, 1, 15), Vec3d{});
  const ShapeTree<Real> tree(table);
  Dice dice(79);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    Rays<L> rays;
    const double far[] = {3, 1e3, 1e8, 1e20};
    for (auto& ray : rays.ray) {
      const auto id = static_cast<ShapeId>(dice.below(static_cast<int>(table.size())));
      const auto bounds = table.bounds(id);
      ray = bounds ? grazing_ray(dice, *bounds, far[dice.below(4)]) : random_ray<Real>(dice, 1);
      if (dice.below(8) == 0) ray.direction = Real(0x1p-100) * ray.direction;
      if (dice.below(8) == 0) ray.direction[dice.below(3)] *= Real(0x1p-60);
    }
    hits += compare_paths(table, tree, rays, dice, 2);
    ASSERT_FALSE(this->HasFailure()) << i;
  }
  EXPECT_GT(hits, 100 * L::kWidth);
}

}  // namespace
}  // namespace alhazen::render
