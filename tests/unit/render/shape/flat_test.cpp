// The plane and the disc.
#include <gtest/gtest.h>

#include "render/shape/from_scene.h"
#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

TEST(Plane, ClosedForms) {
  const Plane<double> ground = from_scene(alhazen::Plane{{0, 1, 0}, -1}, Vec3d{});
  const Ray<double> ray{{3, 1, 5}, {0, -0.5, 0.25}};
  const auto hits = crossings(ground, ray, Departure());
  ASSERT_EQ(hits.size(), 1);
  EXPECT_EQ(hits[0].t, 4);
  EXPECT_TRUE(hits[0].enters);
  const auto point = surface(ground, ray, hits[0]);
  EXPECT_EQ(point.position, Vec3d(3, -1, 6));
  EXPECT_EQ(point.u, 3);
  EXPECT_EQ(point.v, 6);
  EXPECT_EQ(crossings(ground, {{0, 1, 0}, {1, 0, 0}}, Departure()).size(), 0);
  EXPECT_EQ(crossings(ground, {{0, 1, 0}, {1, 1, 0}}, Departure()).size(), 0);
  EXPECT_EQ(crossings(ground, ray, Departure{0}).size(), 0);
  EXPECT_EQ(crossings(ground, {{0, -1, 0}, {1, 1, 0}}, Departure())[0].t, 0);
  EXPECT_TRUE(contains(ground, Vec3d{9, -1.5, 9}));
  EXPECT_FALSE(contains(ground, Vec3d{9, -1, 9}));
}

// A8: t = height / sine at any grazing angle, with no farthest distance.
TEST(Plane, GrazingHasNoLimit) {
  const Plane<double> ground = from_scene(alhazen::Plane{{0, 1, 0}, 0}, Vec3d{});
  for (int k = 1; k <= 1000; ++k) {
    const double sine = std::ldexp(1.0, -k);
    const auto hits = crossings(ground, {{0, 3, 0}, {1, -sine, 0}}, Departure());
    ASSERT_EQ(hits.size(), 1) << k;
    EXPECT_EQ(hits[0].t, std::ldexp(3.0, k)) << k;
  }
}

// The offset of a far plane seen from a far camera loses nothing to the distance.
TEST(Plane, RebasedExactly) {
  const Vec3d n{0.6, 0.8, 0};  // not quite unit, nor representable: so much the better
  const Vec3d camera{0x1p40, -0x1p40, 5};
  const Plane<double> plane = from_scene(alhazen::Plane{n, 12345}, camera);
  // 12345 - 2^40 (0.6 - 0.8): products by powers of two are exact, 0.8 - 0.6 is as well.
  EXPECT_EQ(plane.offset, 12345 + 0x1p40 * (n.y - n.x));
}

TEST(Disc, RimAndHole) {
  const Disc<double> ring = from_scene(alhazen::Disc{{0, 2, 0}, {0, 1, 0}, 2, 0.5}, Vec3d{});
  const auto hits_at = [&](double x) {
    return crossings(ring, {{x, 5, 0}, {0, -1, 0}}, Departure()).size();
  };
  EXPECT_EQ(hits_at(0.5 - kU), 0);
  EXPECT_EQ(hits_at(0.5), 1);  // both rims belong to the disc
  EXPECT_EQ(hits_at(-2), 1);
  EXPECT_EQ(hits_at(2 + 4 * kU), 0);
  const Ray<double> ray{{0, 0, 1.25}, {0, 1, 0}};
  const auto hits = crossings(ring, ray, Departure());
  ASSERT_EQ(hits.size(), 1);
  EXPECT_EQ(hits[0].t, 2);
  EXPECT_FALSE(hits[0].enters);  // from below
  const auto point = surface(ring, ray, hits[0]);
  EXPECT_EQ(point.position, Vec3d(0, 2, 1.25));
  EXPECT_EQ(point.normal, Vec3d(0, 1, 0));
  EXPECT_EQ(point.u, 0.25);
  EXPECT_EQ(point.v, 0.5);
  EXPECT_EQ(crossings(ring, {{1, 2, 0}, {0, 1, 0}}, Departure{0}).size(), 0);
}

}  // namespace
}  // namespace alhazen::render
