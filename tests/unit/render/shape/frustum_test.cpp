#include "render/shape/frustum.h"

#include <gtest/gtest.h>

#include "render/shape/convert.h"
#include "render/shape/from_scene.h"
#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

using frustum::kLargeCap;
using frustum::kSide;
using frustum::kSmallCap;

Frustum<double> cylinder(bool capped) {
  return from_scene(Cylinder{{0, 0, 0}, {0, 4, 0}, 2, capped}, Vec3d{});
}
// Half angle 45 degrees, apex at y = 2.
Frustum<double> pointed(bool capped) {
  return from_scene(Cone{{0, 0, 0}, {0, 2, 0}, 2, 0, capped}, Vec3d{});
}

TEST(Cylinder, ClosedForms) {
  const Ray<double> across{{-5, 1, 0}, {1, 0, 0}};
  for (const bool capped : {true, false}) {
    const auto hits = crossings(cylinder(capped), across, Departure());
    ASSERT_EQ(hits.size(), 2);
    EXPECT_EQ(hits[0].t, 3);
    EXPECT_EQ(hits[1].t, 7);
    EXPECT_TRUE(hits[0].enters);
    EXPECT_EQ(hits[0].face, kSide);
    const auto point = surface(cylinder(capped), across, hits[0]);
    EXPECT_EQ(point.position, Vec3d(-2, 1, 0));
    EXPECT_EQ(point.normal, Vec3d(-1, 0, 0));
    EXPECT_EQ(point.v, 0.25);
  }
  const Ray<double> along{{1, -3, 0}, {0, 1, 0}};
  const auto caps = crossings(cylinder(true), along, Departure());
  ASSERT_EQ(caps.size(), 2);
  EXPECT_EQ(caps[0].t, 3);
  EXPECT_EQ(caps[0].face, kSmallCap);
  EXPECT_EQ(caps[1].t, 7);
  EXPECT_EQ(caps[1].face, kLargeCap);
  EXPECT_EQ(surface(cylinder(true), along, caps[0]).normal, Vec3d(0, -1, 0));
  EXPECT_EQ(surface(cylinder(true), along, caps[0]).v, 0.5);
  EXPECT_EQ(crossings(cylinder(false), along, Departure()).size(), 0);
  // Along the side itself, through the rims: the closed solid is met, from cap to cap.
  EXPECT_EQ(crossings(cylinder(true), {{2, -3, 0}, {0, 1, 0}}, Departure()).size(), 2);
  EXPECT_EQ(crossings(cylinder(true), {{2 + 4 * kU, -3, 0}, {0, 1, 0}}, Departure()).size(), 0);
}

// In by the open end, out through the side: seen from inside.
TEST(Cylinder, OpenEndLetsIn) {
  const Ray<double> ray{{0, 6, 0}, {2, -3, 0}};
  const auto hits = crossings(cylinder(false), ray, Departure());
  ASSERT_EQ(hits.size(), 1);
  EXPECT_EQ(hits[0].t, 1);
  EXPECT_FALSE(hits[0].enters);
  EXPECT_EQ(crossings(cylinder(true), ray, Departure())[0].face, kLargeCap);
}

TEST(Cone, ClosedForms) {
  const Ray<double> across{{-5, 1, 0}, {1, 0, 0}};
  const auto hits = crossings(pointed(true), across, Departure());
  ASSERT_EQ(hits.size(), 2);
  EXPECT_EQ(hits[0].t, 4);
  EXPECT_EQ(hits[1].t, 6);
  const auto point = surface(pointed(true), across, hits[0]);
  EXPECT_EQ(point.position, Vec3d(-1, 1, 0));
  // (-1, 1, 0)/sqrt 2 outward: two roundings of the normalisation.
  EXPECT_NEAR(point.normal.x, -std::sqrt(0.5), 2 * kU);
  EXPECT_NEAR(point.normal.y, std::sqrt(0.5), 2 * kU);
  EXPECT_EQ(point.v, 0.5);
  // Down the axis: the apex, then the base.
  const auto axis = crossings(pointed(true), {{0, 5, 0}, {0, -1, 0}}, Departure());
  ASSERT_EQ(axis.size(), 2);
  EXPECT_EQ(axis[0].t, 3);
  EXPECT_EQ(axis[1].t, 5);
  EXPECT_EQ(axis[1].face, kLargeCap);
  // The second nappe, above the apex, is not there.
  EXPECT_EQ(crossings(pointed(true), {{-5, 3, 0}, {1, 0, 0}}, Departure()).size(), 0);
  EXPECT_EQ(crossings(pointed(false), {{-5, 3, 0}, {1, 0, 0}}, Departure()).size(), 0);
}

// A10: along a generator a = 0, and through the apex.
TEST(Cone, GeneratorsAndApex) {
  // Parallel to the generator on the right, one unit inside: enters by the left side, leaves below.
  const Ray<double> inside{{-3, 4, 0}, {1, -1, 0}};
  const auto hits = crossings(pointed(true), inside, Departure());
  ASSERT_EQ(hits.size(), 2);
  EXPECT_EQ(hits[0].t, 2.5);
  EXPECT_EQ(hits[0].face, kSide);
  EXPECT_EQ(hits[1].t, 4);
  EXPECT_EQ(hits[1].face, kLargeCap);
  // Just outside: nothing.
  EXPECT_EQ(crossings(pointed(true), {{-1, 4, 0}, {1, -1, 0}}, Departure()).size(), 0);
  // Through the apex, steeper than the side: in at the apex, out at the base.
  const auto apex = crossings(pointed(true), {{-1, 4, 0}, {1, -2, 0}}, Departure());
  ASSERT_EQ(apex.size(), 2);
  EXPECT_EQ(apex[0].t, 1);
  EXPECT_EQ(apex[1].t, 2);
  // Through the apex, flatter than the side: touches it.
  const auto touch = crossings(pointed(true), {{-2, 2, 0}, {1, 0, 0}}, Departure());
  ASSERT_EQ(touch.size(), 2);
  EXPECT_EQ(touch[0].t, touch[1].t);
}

// Equal radii but for the last bit: the cylinder's answer, continuously.
TEST(Cone, TendsToTheCylinder) {
  const auto nearly = from_scene(Cone{{0, 0, 0}, {0, 4, 0}, 2, 2 - 4 * kU, true}, Vec3d{});
  Dice dice(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d target{dice.uniform(-1.5, 1.5), dice.uniform(0.1, 3.9), dice.uniform(-1, 1)};
    const Vec3d d = dice.direction();
    const Ray<double> ray{target - 10.0 * d, d};
    const auto a = crossings(cylinder(true), ray, Departure());
    const auto b = crossings(nearly, ray, Departure());
    ASSERT_EQ(a.size(), b.size()) << i;
    // The frame hangs from the other end; the condition of the roots (the sine of the angle at
    // which the ray meets the side, here above 0.01) times a handful of roundings of sizes to 20.
    for (int k = 0; k < a.size(); ++k)
      EXPECT_NEAR(a[k].t, b[k].t, 100 * 20 * 16 * kU);
  }
}

TEST(Frustum, EitherEndMayBeTheBase) {
  const auto up = from_scene(Cone{{0, 0, 0}, {0, 2, 0}, 2, 1, true}, Vec3d{});
  const auto down = from_scene(Cone{{0, 2, 0}, {0, 0, 0}, 1, 2, true}, Vec3d{});
  const Ray<double> ray{{-5, 0.5, 0.25}, {1, 0.1, 0}};
  const auto a = crossings(up, ray, Departure()), b = crossings(down, ray, Departure());
  ASSERT_EQ(a.size(), 2);
  ASSERT_EQ(b.size(), 2);
  EXPECT_EQ(a[0].t, b[0].t);
  EXPECT_EQ(surface(up, ray, a[0]).v, 1 - surface(down, ray, b[0]).v);
}

TEST(Frustum, Contains) {
  EXPECT_TRUE(contains(cylinder(true), Vec3d{1.9, 3.9, 0}));
  EXPECT_FALSE(contains(cylinder(true), Vec3d{2, 1, 0}));
  EXPECT_FALSE(contains(cylinder(false), Vec3d{0, 1, 0}));
  EXPECT_TRUE(contains(pointed(true), Vec3d{0, 1.99, 0}));
  EXPECT_FALSE(contains(pointed(true), Vec3d{1, 1.5, 0}));
  EXPECT_FALSE(contains(pointed(true), Vec3d{0, 3, 0}));
}

#if ALHAZEN_HAS_QUAD
// A9, A10: cylinders and cones of any slenderness against the same kernel in Quad. The frame's
// products round the ray's coordinates, of size up to `reach`, before anything is decided; a root
// then moves by that over the sine of the angle between ray and side, here >= 0.05, and by the
// curvature's share of it, which the same factor bounds.
TEST(Frustum, AgreesWithQuad) {
  Dice dice(19);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const double length_over_radius = std::ldexp(1.0, dice.below(28));
    const Vec3d axis = dice.direction();
    const double small = i % 3 == 0 ? 0 : dice.uniform(0.1, 1);
    const Frustum<double> shape =
        from_scene(Cone{{}, length_over_radius * axis, 1, i % 5 == 0 ? 1 : small, true}, Vec3d{});
    const Vec3d target = dice.uniform(0, length_over_radius) * axis;
    const Vec3d d = dice.direction();
    const Ray<double> ray{target - 5.0 * d, d};
    const auto got = crossings(shape, ray, Departure());
    const auto truth = crossings(convert<Quad>(shape),
                                 {Vec3<Quad>(ray.origin), Vec3<Quad>(ray.direction)}, Departure());
    ASSERT_EQ(got.size(), truth.size()) << i;
    const double reach = length(ray.origin) + length_over_radius;
    for (int k = 0; k < got.size(); ++k) {
      if (got[k].face != truth[k].face) continue;
      const auto normal = surface(shape, ray, got[k]).normal;
      const double sine = absolute(dot(normal, d));
      if (sine < 0.05) continue;
      ++hits;
      EXPECT_LE(absolute(got[k].t - static_cast<double>(truth[k].t)),
                16 * kU * reach / (sine * sine))
          << i;
    }
  }
  EXPECT_GT(hits, 15000);
}
#endif

}  // namespace
}  // namespace alhazen::render
