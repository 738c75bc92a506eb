#include "render/shape/sphere.h"

#include <gtest/gtest.h>

#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

const Sphere<double> kUnit{{0, 0, 0}, 1};

TEST(Sphere, ClosedForms) {
  const Sphere<double> sphere{{1, 2, 3}, 2};
  const auto hits = crossings(sphere, {{1, 2, -7}, {0, 0, 1}}, Departure());
  ASSERT_EQ(hits.size(), 2);
  EXPECT_EQ(hits[0].t, 8);
  EXPECT_TRUE(hits[0].enters);
  EXPECT_EQ(hits[1].t, 12);
  EXPECT_FALSE(hits[1].enters);
  const auto point = surface(sphere, {{1, 2, -7}, {0, 0, 1}}, hits[0]);
  EXPECT_EQ(point.position, Vec3d(1, 2, 1));
  EXPECT_EQ(point.normal, Vec3d(0, 0, -1));
  EXPECT_EQ(point.u, 0.75);
  EXPECT_EQ(point.v, 0.5);
}

TEST(Sphere, Parametrisation) {
  const auto uv = [](Vec3d from) {
    const Ray<double> ray{2 * from, -from};
    return surface(kUnit, ray, crossings(kUnit, ray, Departure())[0]);
  };
  EXPECT_EQ(uv({1, 0, 0}).u, 0);
  EXPECT_EQ(uv({0, 0, 1}).u, 0.25);
  EXPECT_EQ(uv({-1, 0, 0}).u, 0.5);
  EXPECT_EQ(uv({0, 1, 0}).v, 1);
  EXPECT_EQ(uv({0, -1, 0}).v, 0);
}

// A5: origins at the centre and on the surface.
TEST(Sphere, SpecialOrigins) {
  const auto center = crossings(kUnit, {{0, 0, 0}, {0, 0, 1}}, Departure());
  ASSERT_EQ(center.size(), 1);
  EXPECT_EQ(center[0].t, 1);
  EXPECT_FALSE(center[0].enters);
  // On the surface by chance, both ends count over the closed interval t >= 0.
  EXPECT_EQ(crossings(kUnit, {{0, 0, -1}, {0, 0, 1}}, Departure()).size(), 2);
  EXPECT_EQ(crossings(kUnit, {{0, 0, -1}, {0, 0, 1}}, Departure())[0].t, 0);
  // Leaving it by name, the root at 0 does not.
  const auto through = crossings(kUnit, {{0, 0, -1}, {0, 0, 1}}, Departure{0, Side::kBelow});
  ASSERT_EQ(through.size(), 1);
  EXPECT_EQ(through[0].t, 2);
  EXPECT_EQ(crossings(kUnit, {{0, 0, -1}, {0, 0, -1}}, Departure{0}).size(), 0);
  // A tangent touches once, counted as in and out.
  const auto tangent = crossings(kUnit, {{1, 0, -3}, {0, 0, 1}}, Departure());
  ASSERT_EQ(tangent.size(), 2);
  EXPECT_EQ(tangent[0].t, 3);
  EXPECT_EQ(tangent[1].t, 3);
}

TEST(Sphere, Contains) {
  EXPECT_TRUE(contains(kUnit, Vec3d{0.5, 0.5, 0.5}));
  EXPECT_FALSE(contains(kUnit, Vec3d{1, 0, 0}));
  EXPECT_TRUE(contains(kUnit, Vec3d{1 - kU, 0, 0}));
  EXPECT_FALSE(contains(kUnit, Vec3d{0.6, 0.6, 0.6}));
}

#if ALHAZEN_HAS_QUAD
// The rays and spheres are exact in both types, so the Quad kernel gives the truth. Errors in eps
// of double, relative to t.
double worst_error(double distance, double radius, double impact_from, double impact_to,
                   bool ground) {
  double worst = 0;
  Dice dice(17);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d d = dice.direction();
    const Vec3d side = normalized(cross(d, dice.direction()));
    const double impact = radius * dice.uniform(impact_from, impact_to);
    const Vec3d center = ground ? Vec3d{0, -radius, 0} : distance * d + impact * side;
    const Ray<double> ray{ground ? Vec3d{0, distance, 0} : Vec3d{},
                          ground ? Vec3d{d.x, -absolute(d.y), d.z} : d};
    const auto got = crossings(Sphere<double>{center, radius}, ray, Departure());
    const auto truth = crossings(Sphere<Quad>{Vec3<Quad>(center), static_cast<Quad>(radius)},
                                 {Vec3<Quad>(ray.origin), Vec3<Quad>(ray.direction)}, Departure());
    if (got.size() != truth.size()) return 1e9;
    for (int k = 0; k < got.size(); ++k) {
      const Quad error = absolute(static_cast<Quad>(got[k].t) - truth[k].t) / truth[k].t;
      worst = larger(worst, static_cast<double>(error) / kU);
    }
  }
  return worst;
}

// A1 to A3 of docs/hard_cases.md: 4 eps, wherever the sphere is.
TEST(Sphere, ErrorStaysSmallNearFarAndOnTheGround) {
  EXPECT_LE(worst_error(3, 1, 0, 0.9, false), 4);
  EXPECT_LE(worst_error(1e3, 1, 0, 0.9, false), 4);
  EXPECT_LE(worst_error(1e6, 1, 0, 0.9, false), 4);
  EXPECT_LE(worst_error(1e9, 1, 0, 0.9, false), 4);
  EXPECT_LE(worst_error(2, 1e6, 0, 0, true), 4);
  EXPECT_LE(worst_error(2, 1e10, 0, 0, true), 4);
  EXPECT_LE(worst_error(2, 1e12, 0, 0, true), 4);
}

// A1: rays at R (1 -+ 2^-k) from the centre. Whether they hit is decided rightly down to 4 eps, and
// t is right to a few eps of the half chord's condition, which the two-word sums leave untouched.
TEST(Sphere, GrazingRaysAreDecidedRightly) {
  Dice dice(18);
  int checked = 0;
  for (int k = 4; k <= 46; ++k) {
    for (int i = 0; i < 200; ++i) {
      const Vec3d d = dice.direction(), side = normalized(cross(d, dice.direction()));
      const double impact = 1 + (i % 2 == 0 ? 1 : -1) * std::ldexp(1.0, -k);
      const Ray<double> ray{impact * side - dice.uniform(0.1, 10) * d, d};
      const Ray<Quad> same{Vec3<Quad>(ray.origin), Vec3<Quad>(ray.direction)};
      // The impact that the rounded numbers really have.
      const Vec3<Quad> moment = cross(same.origin, same.direction);
      const Quad distance = length(moment) / length(same.direction);
      if (absolute(distance - 1) <= static_cast<Quad>(4 * kU)) continue;
      ++checked;
      const auto got = crossings(kUnit, ray, Departure());
      const auto truth = crossings(Sphere<Quad>{{}, 1}, same, Departure());
      ASSERT_EQ(got.size(), truth.size()) << k << ' ' << i;
      for (int n = 0; n < got.size(); ++n) {
        EXPECT_LE(
            static_cast<double>(absolute(static_cast<Quad>(got[n].t) - truth[n].t) / truth[n].t) /
                kU,
            4)
            << k;
      }
    }
  }
  EXPECT_GT(checked, 8000);
}
#endif

}  // namespace
}  // namespace alhazen::render
