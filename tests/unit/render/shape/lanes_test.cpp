// Lanes of rays meet what single rays meet, to the last bit.
#include <gtest/gtest.h>

#include "render/shape/convert.h"
#include "render/shape/from_scene.h"
#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

template <class Real>
Vec3<Real> lane_of(const Vec3<Real>& v, int /*lane*/) {
  return v;
}
template <class T, int W>
Vec3<T> lane_of(const Vec3<Lanes<T, W>>& v, int lane) {
  return {v.x[lane], v.y[lane], v.z[lane]};
}

// The same number with the same sign of a zero; any NaN is any other.
template <class Real>
::testing::AssertionResult same_number(Real a, Real b) {
  const bool same = a == b ? ScalarTraits<Real>::sign_bit(a) == ScalarTraits<Real>::sign_bit(b)
                           : is_nan(a) && is_nan(b);
  if (same) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << static_cast<double>(a) << " in the lane, " << static_cast<double>(b) << " alone";
}
template <class Real>
::testing::AssertionResult same_vector(Vec3<Real> a, Vec3<Real> b) {
  for (int i = 0; i < 3; ++i) {
    if (auto same = same_number(a[i], b[i]); !same) return same << ", axis " << i;
  }
  return ::testing::AssertionSuccess();
}

template <class L>
void expect_same_pair(const CrossingPair<L>& lanes, int lane,
                      const CrossingPair<ScalarOf<L>>& alone) {
  const auto expect_same = [&](bool has, bool has_alone, const Crossing<L>& found,
                               const Crossing<ScalarOf<L>>& expected) {
    ASSERT_EQ(has, has_alone);
    if (!has) return;
    EXPECT_TRUE(same_number(found.t[lane], expected.t));
    EXPECT_EQ(found.face[lane], expected.face);
    EXPECT_EQ(found.enters[lane], expected.enters);
  };
  expect_same(lanes.has_near[lane], alone.has_near, lanes.near, alone.near);
  expect_same(lanes.has_far[lane], alone.has_far, lanes.far, alone.far);
}

template <class L>
void expect_same_surface(const Surface<L>& lanes, int lane, const Surface<ScalarOf<L>>& alone) {
  EXPECT_TRUE(same_vector(lane_of(lanes.position, lane), alone.position));
  EXPECT_TRUE(same_vector(lane_of(lanes.normal, lane), alone.normal));
  EXPECT_TRUE(same_vector(lane_of(lanes.shading_normal, lane), alone.shading_normal));
  EXPECT_TRUE(same_number(lanes.u[lane], alone.u));
  EXPECT_TRUE(same_number(lanes.v[lane], alone.v));
}

// W single rays, and the same rays as lanes.
template <class L>
struct Batch {
  using Real = ScalarOf<L>;
  std::array<Ray<Real>, L::kWidth> rays;

  Ray<L> lanes() const {
    Ray<L> result;
    for (int i = 0; i < L::kWidth; ++i)
      put(result, i, rays[static_cast<std::size_t>(i)]);
    return result;
  }

 private:
  static void put(Ray<L>& into, int lane, const Ray<Real>& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      into.origin[axis].set(lane, ray.origin[axis]);
      into.direction[axis].set(lane, ray.direction[axis]);
    }
  }
};

// From near and far, at the shape and past it, a fifth of them along an axis, a fifth grazing what
// is about 1 in size, a tenth from very near to the middle.
template <class Real>
Ray<Real> any_ray(Dice& dice) {
  const Vec3d target = dice.in_cube(1.5);
  const double distance = std::ldexp(1.0, dice.below(12) - 3);
  Vec3d origin = target + distance * dice.direction(), direction = target - origin;
  switch (dice.below(10)) {
    case 0:
    case 1: {  // along an axis, with zeros of both signs
      const int axis = dice.below(3);
      const double zero = dice.below(2) == 0 ? 0.0 : -0.0;
      direction = {zero, -zero, zero};
      direction[axis] = dice.below(2) == 0 ? 1 : -1;
      origin[axis] = -8 * direction[axis];
      break;
    }
    case 2:
    case 3: {  // past the unit ball, by little
      const Vec3d normal = dice.direction(), along = cross(normal, dice.direction());
      const double height = 1 + std::ldexp(dice.uniform(-1, 1), -dice.below(50));
      origin = height * normal - 4.0 * along;
      direction = along;
      break;
    }
    case 4:
      origin = std::ldexp(1.0, -dice.below(60)) * dice.direction();
      break;
    default:
      break;
  }
  return {Vec3<Real>(origin), Vec3<Real>(direction)};
}

// Calls try_kernel(kernel) with kernels of every kind, about 1 in size.
template <class Real, class Function>
void for_each_kernel(Dice& dice, const Function& try_kernel) {
  const Vec3d at = dice.in_cube(0.5), axis = dice.direction();
  const auto kernel = [](const auto& shape) { return convert<Real>(from_scene(shape, Vec3d())); };
  try_kernel(kernel(alhazen::Sphere{{}, 1}));
  try_kernel(kernel(alhazen::Sphere{at, dice.uniform(0.2, 2)}));
  try_kernel(kernel(alhazen::Sphere{{0, -1e9, 0}, 1e9}));
  try_kernel(kernel(alhazen::Plane{axis, dice.uniform(-1, 1)}));
  try_kernel(kernel(alhazen::Plane{{0, 1, 0}, 0}));
  try_kernel(kernel(alhazen::Box{{-1, -1, -1}, {1, 1, 1}}));
  try_kernel(kernel(alhazen::Disc{at, axis, 1, 0.3}));
  try_kernel(kernel(alhazen::Disc{{}, {0, 0, 1}, 1, 0}));
  for (const bool capped : {true, false}) {
    try_kernel(kernel(Cylinder{at, at + axis, 0.8, capped}));
    try_kernel(kernel(Cylinder{{0, -1, 0}, {0, 1, 0}, 1, capped}));
    try_kernel(kernel(Cone{at, at + axis, 1, 0, capped}));
    try_kernel(kernel(Cone{{0, -1, 0}, {0, 1, 0}, 0.5, 1, capped}));
  }
  alhazen::Triangle triangle{{at, dice.in_cube(2), dice.in_cube(2)}, {}};
  try_kernel(kernel(triangle));
  triangle.normals = {dice.direction(), dice.direction(), dice.direction()};
  try_kernel(kernel(triangle));
  try_kernel(kernel(alhazen::Triangle{{Vec3d{-1, -1, 0}, Vec3d{1, -1, 0}, Vec3d{0, 1, 0}}, {}}));
  try_kernel(kernel(Quad4{at, dice.in_cube(2), dice.in_cube(2)}));
}

// The crossings of rays from elsewhere, the surface there, and how rays go on from it: reflected,
// across, and wherever.
template <class L, template <class> class Kernel>
void try_lanes(const Kernel<ScalarOf<L>>& kernel, Dice& dice, int& crossed) {
  using Real = ScalarOf<L>;
  const Kernel<L> wide = convert<L>(kernel);
  Batch<L> batch;
  for (Ray<Real>& ray : batch.rays)
    ray = any_ray<Real>(dice);
  const Ray<L> rays = batch.lanes();
  const CrossingPair<L> found = crossings(wide, rays);
  const Surface<L> points = surface(wide, rays, found.near);
  Batch<L> onward = batch;
  OwnDeparture<L> from;
  for (int i = 0; i < L::kWidth; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    const Ray<Real>& ray = batch.rays[lane];
    const CrossingPair<Real> alone = crossings(kernel, ray);
    expect_same_pair(found, i, alone);
    const int side = dice.below(3);
    from.side.set(i, side);
    from.face.set(i, 0);
    if (!alone.has_near) continue;
    ++crossed;
    const Surface<Real> point = surface(kernel, ray, alone.near);
    expect_same_surface(points, i, point);
    from.face.set(i, alone.near.face);
    onward.rays[lane] = {point.position, dice.below(2) == 0
                                             ? ray.direction
                                             : reflected(ray.direction, point.normal)};
  }
  const CrossingPair<L> gone = own_crossings(wide, onward.lanes(), from);
  for (int i = 0; i < L::kWidth; ++i) {
    const OwnDeparture<Real> alone{static_cast<int>(from.face[i]), static_cast<int>(from.side[i])};
    expect_same_pair(gone, i,
                     own_crossings(kernel, onward.rays[static_cast<std::size_t>(i)], alone));
  }
}

template <class L>
void try_kernels(int rays = 2000) {
  Dice dice(1);
  int crossed = 0;
  for (int round = 0; round < rays / L::kWidth; ++round) {
    for_each_kernel<ScalarOf<L>>(dice,
                                 [&](const auto& kernel) { try_lanes<L>(kernel, dice, crossed); });
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(crossed, 5 * rays);  // with twenty kernels
}

TEST(ShapeLanes, FourDoublesAreFourSingleOnes) {
  try_kernels<Lanes<double, 4>>();
}
TEST(ShapeLanes, EightDoublesAreEightSingleOnes) {
  try_kernels<Lanes<double, 8>>();
}
TEST(ShapeLanes, EightFloatsAreEightSingleOnes) {
  try_kernels<Lanes<float, 8>>();
}
TEST(ShapeLanes, OneLaneIsOneSingleOne) {
  try_kernels<Lanes<double, 1>>();
#if ALHAZEN_HAS_QUAD
  try_kernels<Lanes<Quad, 1>>(100);
#endif
}

// Every kind, a third of them in object frames of their own.
std::vector<Shape> zoo() {
  Dice dice(7);
  std::vector<Shape> shapes;
  for (int i = 0; i < 6; ++i) {
    std::vector<Geometry> kinds = random_solids(dice, 1);
    kinds.push_back(alhazen::Plane{dice.direction(), dice.uniform(-1, 1)});
    kinds.push_back(alhazen::Disc{dice.in_cube(1), dice.direction(), 1.5, 0.2});
    kinds.push_back(Quad4{dice.in_cube(1), dice.in_cube(2), dice.in_cube(2)});
    alhazen::Triangle triangle{{dice.in_cube(2), dice.in_cube(2), dice.in_cube(2)}, {}};
    if (i % 2 == 0) triangle.normals = {dice.direction(), dice.direction(), dice.direction()};
    kinds.push_back(triangle);
    for (const Geometry& geometry : kinds) {
      shapes.push_back(shape_of(geometry));
      if (dice.below(3) != 0) continue;
      const Affined stretch = scaling({dice.uniform(0.5, 2), -dice.uniform(0.5, 2), 1});
      shapes.back().world_from_object =
          translation(dice.in_cube(1)) * rotation(dice.direction(), dice.uniform(0, 360)) * stretch;
    }
  }
  return shapes;
}

// Each ray is aimed until its lane's shape is met: `same_shape` says whether that is one for all.
template <class L>
void try_table(bool same_shape, int tries = 8000) {
  using Real = ScalarOf<L>;
  const ShapeTable<Real> table(zoo(), {0.5, 0.25, -3});
  Dice dice(3);
  int met = 0;
  for (int round = 0; round < tries / L::kWidth; ++round) {
    const auto any_shape = [&] { return dice.below(static_cast<int>(table.size())); };
    const int common = any_shape();
    Batch<L> batch;
    IntOf<L> shape;
    std::uint32_t hit_lanes = 0;
    Crossing<L> crossing;
    for (int i = 0; i < L::kWidth; ++i) {
      Ray<Real>& ray = batch.rays[static_cast<std::size_t>(i)];
      ray = any_ray<Real>(dice);
      ray.origin = ray.origin - table.world_origin();
      const int id = same_shape ? common : any_shape();
      shape.set(i, id);
      const CrossingPair<Real> alone = table.crossings(static_cast<ShapeId>(id), ray);
      if (!alone.has_near) continue;
      crossing.t.set(i, alone.near.t);
      crossing.face.set(i, alone.near.face);
      hit_lanes |= 1U << i;
    }
    const auto active = MaskOf<L>::from_bits(hit_lanes);
    const Ray<L> rays = batch.lanes();
    const CrossingPair<L> first = table.crossings(static_cast<ShapeId>(common), rays);
    const CrossingPair<L> sheared =
        table.crossings(static_cast<ShapeId>(common), ShearedRay<L>(rays));
    const SurfacePoint<L> points = table.surface(shape, rays, crossing, active);
    const SurfacePoint<L> plain = table.plain_surface(shape, rays, crossing, active);
    Batch<L> onward = batch;
    IntOf<L> side;
    for (int i = 0; i < L::kWidth; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      const auto of_common = table.crossings(static_cast<ShapeId>(common), batch.rays[lane]);
      expect_same_pair(first, i, of_common);
      expect_same_pair(sheared, i, of_common);
      if (!active[i]) continue;
      ++met;
      const Crossing<Real> alone{crossing.t[i], static_cast<int>(crossing.face[i]), false};
      const auto id = static_cast<ShapeId>(shape[i]);
      const SurfacePoint<Real> point = table.surface(id, batch.rays[lane], alone);
      expect_same_surface<L>(points, i, point);
      EXPECT_TRUE(same_vector(lane_of(points.object_position, i), point.object_position));
      expect_same_surface<L>(plain, i, table.plain_surface(id, batch.rays[lane], alone));
      onward.rays[lane].origin = point.position;
      side.set(i, dice.below(3));
    }
    const CrossingPair<L> gone =
        table.own_crossings(shape, onward.lanes(), crossing.face, side, active);
    for (int i = 0; i < L::kWidth; ++i) {
      if (!active[i]) {
        EXPECT_FALSE(gone.has_near[i] || gone.has_far[i]);
        continue;
      }
      const Departure from{static_cast<int>(crossing.face[i]), static_cast<Side>(side[i])};
      const auto alone = table.crossings(static_cast<ShapeId>(shape[i]),
                                         onward.rays[static_cast<std::size_t>(i)], from);
      ASSERT_EQ(gone.has_far[i], alone.size() == 1);
      EXPECT_FALSE(gone.has_near[i]);
      if (alone.size() == 0) continue;
      EXPECT_TRUE(same_number(gone.far.t[i], alone[0].t));
      EXPECT_EQ(gone.far.face[i], alone[0].face);
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(met, tries / 8);
}

TEST(ShapeLanes, EachLaneHasAShapeOfItsOwn) {
  try_table<Lanes<double, 4>>(false);
  try_table<Lanes<double, 1>>(false);
#if ALHAZEN_HAS_QUAD
  try_table<Lanes<Quad, 1>>(false, 400);
#endif
  try_table<Lanes<double, 8>>(false);
  try_table<Lanes<float, 8>>(false);
}
TEST(ShapeLanes, AllLanesHaveOneShape) {
  try_table<Lanes<double, 4>>(true);
  try_table<Lanes<float, 8>>(true);
}

}  // namespace
}  // namespace alhazen::render
