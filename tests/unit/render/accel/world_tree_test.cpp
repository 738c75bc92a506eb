// The trees of instances, for single rays and for packets, against the loop over every shape of
// every instance: not one bit may differ.
#include "render/accel/world_tree.h"

#include <gtest/gtest.h>

#include "unit/render/accel/packets.h"
#include "unit/render/accel/paths.h"

namespace alhazen::render {
namespace {

Affined random_map(Dice& dice, double scale) {
  const Affined turn = rotation(dice.direction(), dice.uniform(0, 360));
  const Affined stretch =
      scaling({dice.uniform(0.2, 2), -dice.uniform(0.2, 2), dice.uniform(0.01, 2)});
  return translation(scale * dice.in_cube(4)) * turn * (dice.below(2) == 0 ? stretch : Affined());
}

// Three prototypes of every kind of shape, the second with a plane among them; a dozen instances,
// some at one place, with single shapes between them.
SceneShapes random_instances(std::uint64_t seed, double scale, int count) {
  Dice dice(seed + 77);
  SceneShapes shapes;
  for (std::uint64_t p = 0; p < 3; ++p) {
    std::vector<Shape> group = mixed_shapes(seed + 10 * p, scale, count);
    if (p != 1) {
      std::erase_if(
          group, [](const Shape& s) { return std::holds_alternative<alhazen::Plane>(s.geometry); });
    }
    shapes.add_prototype(group);
  }
  const std::vector<Shape> singles = mixed_shapes(seed + 5, scale, 2);
  Affined map = random_map(dice, scale);
  for (int i = 0; i < 12; ++i) {
    if (dice.below(4) != 0) map = random_map(dice, scale);
    // The one with a plane seldom: it is met by every ray.
    const int p = dice.below(8);
    Instance instance;
    instance.world_from_group = map;
    instance.prototype = p == 0 ? 1 : 2 * static_cast<PrototypeId>(p & 1);
    shapes.push_back(instance);
    if (i % 2 == 0) shapes.push_back(singles[static_cast<std::size_t>(i)]);
  }
  return shapes;
}

// The lattice of coincident_shapes, moved by whole numbers: shapes of different instances share
// faces, and some instances are there twice.
SceneShapes lattice_instances() {
  SceneShapes shapes;
  const PrototypeId prototype = shapes.add_prototype(coincident_shapes(1));
  for (const Vec3d by : {Vec3d{0, 0, 0}, Vec3d{2, 0, 0}, Vec3d{2, 0, 0}, Vec3d{-1, 3, 0}}) {
    Instance instance;
    instance.world_from_group = translation(by);
    instance.prototype = prototype;
    shapes.push_back(instance);
    shapes.push_back(shape_of(alhazen::Box{by, by + Vec3d{1, 1, 1}}));
  }
  return shapes;
}

template <class Real>
class WorldTreeOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(WorldTreeOf, Precisions);

TYPED_TEST(WorldTreeOf, RandomInstances) {
  using Real = TypeParam;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 9; ++seed) {
    const double scale = std::ldexp(1.0, static_cast<int>(seed % 3) * 20 - 20);
    const WorldShapes<Real> shapes(random_instances(seed, scale, 6), Vec3d{});
    const WorldTree<Real> tree(shapes);
    Dice dice(seed + 500);
    for (int i = 0; i < 150; ++i) {
      const Ray<Real> ray = random_ray<Real>(dice, scale);
      hits += compare_path(shapes, tree, ray, dice, 3);
      ASSERT_FALSE(this->HasFailure()) << "seed " << seed << " ray " << i;
    }
  }
  EXPECT_GT(hits, 1000);
}

TYPED_TEST(WorldTreeOf, CoincidentInstances) {
  using Real = TypeParam;
  const WorldShapes<Real> shapes(lattice_instances(), Vec3d{});
  const WorldTree<Real> tree(shapes);
  Dice dice(7);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    hits += compare_path(shapes, tree, lattice_ray<Real>(dice, 1), dice, 4);
    ASSERT_FALSE(this->HasFailure()) << "ray " << i;
  }
  EXPECT_GT(hits, 1000);
}

TYPED_TEST(WorldTreeOf, GrazingFarAndExtremeRays) {
  using Real = TypeParam;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const WorldShapes<Real> shapes(random_instances(seed, 1, 6), Vec3d{});
    const WorldTree<Real> tree(shapes);
    Dice dice(seed + 900);
    for (const double distance : {3.0, 1e3, 1e8, 1e20}) {
      for (int i = 0; i < 60; ++i) {
        const auto id = static_cast<ShapeId>(dice.below(static_cast<int>(shapes.size())));
        const auto bounds = shapes.bounds(id);
        if (!bounds) continue;
        Ray<Real> ray = grazing_ray(dice, *bounds, distance);
        if (dice.below(8) == 0) ray.direction = Real(0x1p-100) * ray.direction;
        hits += compare_path(shapes, tree, ray, dice, 2);
        ASSERT_FALSE(this->HasFailure()) << "seed " << seed << " from " << distance << " ray " << i;
      }
    }
  }
  EXPECT_GT(hits, 200);
}

// The same trees for any number of threads.
TEST(WorldTree, ThreadsChangeNothing) {
  SceneShapes scene = random_instances(3, 1, 6);
  Dice dice(5);
  for (int i = 0; i < 9000; ++i) {
    Instance instance;
    instance.world_from_group = random_map(dice, 50);
    scene.push_back(instance);
  }
  const WorldShapes<double> shapes(scene, Vec3d{});
  const WorldTree<double> one(shapes, 1), three(shapes, 3);
  ASSERT_EQ(one.bytes(), three.bytes());
  const auto nodes = one.instances().nodes(), others = three.instances().nodes();
  ASSERT_EQ(nodes.size(), others.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    ASSERT_TRUE(nodes[i].planes == others[i].planes) << i;
}

template <class L>
class WorldPackets : public testing::Test {};
using Widths = testing::Types<Lanes<float, 4>, Lanes<float, 8>, Lanes<double, 2>, Lanes<double, 8>,
                              Lanes<double, 16>>;
TYPED_TEST_SUITE(WorldPackets, Widths);

TYPED_TEST(WorldPackets, RandomInstances) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const double scale = std::ldexp(1.0, static_cast<int>(seed % 3) * 20 - 20);
    const WorldShapes<Real> shapes(random_instances(seed, scale, 6), Vec3d{});
    const WorldTree<Real> tree(shapes);
    Dice dice(seed + 3000);
    for (int i = 0; i < 40; ++i) {
      Rays<L> rays = narrow_rays<L>(dice, scale);
      if (i % 3 == 0) {
        for (auto& ray : rays.ray)
          ray = random_ray<Real>(dice, scale);
      }
      hits += compare_paths(shapes, tree, rays, dice, 3);
      ASSERT_FALSE(this->HasFailure()) << "seed " << seed << " packet " << i;
    }
  }
  EXPECT_GT(hits, 50 * L::kWidth);
}

TYPED_TEST(WorldPackets, CoincidentInstances) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  const WorldShapes<Real> shapes(lattice_instances(), Vec3d{});
  const WorldTree<Real> tree(shapes);
  Dice dice(8);
  int hits = 0;
  for (int i = 0; i < 80; ++i) {
    Rays<L> rays;
    for (auto& ray : rays.ray)
      ray = lattice_ray<Real>(dice, 1);
    if (i % 2 == 0) {  // side by side
      for (auto& ray : rays.ray)
        ray = {rays.ray[0].origin + Vec3<Real>(dice.in_cube(0.01)), rays.ray[0].direction};
    }
    hits += compare_paths(shapes, tree, rays, dice, 4);
    ASSERT_FALSE(this->HasFailure()) << i;
  }
  EXPECT_GT(hits, 50 * L::kWidth);
}

}  // namespace
}  // namespace alhazen::render
