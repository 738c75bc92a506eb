// Margins against their closed forms: a ray that passes an edge by a share 2^-k, for many k.
#include <cmath>
#include <gtest/gtest.h>

#include "render/shape/doubt_flat.h"
#include "render/shape/doubt_solid.h"

namespace alhazen::render {
namespace {

using V = Vec3<double>;

template <class Shape>
std::vector<Doubt<double>> doubts_of(const Shape& shape, const Ray<double>& ray) {
  const Doubts<double> found = doubts(shape, ray, Departure());
  return {found.begin(), found.end()};
}

// 4 roundings of the sums, and the two-word discriminant's.
void expect_margin(double margin, double expected) {
  EXPECT_NEAR(margin / expected, 1, 1e-14) << expected;
}

constexpr int kFinest = 40;

TEST(Doubt, SphereIsPassedByItsDiscriminant) {
  const Sphere<double> ball{V(0, 0, 0), 1};
  const double distance = 4;
  for (int k = 2; k <= kFinest; ++k) {
    for (const int sign : {-1, 1}) {
      const double b = 1 + sign * std::ldexp(1, -k);
      const auto found = doubts_of(ball, {V(b, 0, -distance), V(0, 0, 3)});
      ASSERT_EQ(found.size(), sign < 0 ? 2u : 1u);
      EXPECT_EQ(found[0].crosses, sign < 0);
      const double off = std::abs((1 - b) * (1 + b));
      const double expected = off / (1 + b * b + distance * distance);
      if (sign < 0) expect_margin(found[0].margin, expected);
      if (sign > 0) {  // a sure miss is not summed in two words: 8 roundings of 2 R^2, of 18 R^2
        EXPECT_NEAR(found[0].margin, expected, 0x1p-53);
        EXPECT_NEAR(found[0].t, distance / 3, 1e-15);
      }
    }
  }
}

TEST(Doubt, StartOnASphereIsATie) {
  for (int k = 2; k <= kFinest; ++k) {
    const double r = 1 + std::ldexp(1, -k);
    const auto found = doubts_of(Sphere<double>{V(0, 0, 0), 1}, {V(0, 0, -r), V(0, 0, 1)});
    ASSERT_EQ(found.size(), 2u);
    expect_margin(found[0].margin, (r - 1) * (r + 1) / (r * r + 1));
  }
}

TEST(Doubt, CylinderIsPassedAsASphereIs) {
  const Frustum<double> post{
      {V(0, -1, 0), V(1, 0, 0), V(0, 0, 1), V(0, 1, 0)}, 2, 1, 1, 0, true, true};
  for (int k = 2; k <= kFinest; ++k) {
    for (const int sign : {-1, 1}) {
      const double b = 1 + sign * std::ldexp(1, -k);
      const auto found = doubts_of(post, {V(b, 0, -4), V(0, 0, 1)});
      ASSERT_EQ(found.size(), sign < 0 ? 2u : 1u);
      expect_margin(found[0].margin, std::abs((1 - b) * (1 + b)) / (1 + b * b + 16));
    }
  }
}

TEST(Doubt, BoxIsPassedByTheGapOfItsSlabs) {
  const Box<double> box{V(-1, -1, -1), V(1, 1, 1)};
  for (int k = 2; k <= kFinest; ++k) {
    const double e = std::ldexp(1, -k);
    for (const double x : {1 - e, 1 + e}) {
      const auto parallel = doubts_of(box, {V(x, 0, -4), V(0, 0, 1)});
      EXPECT_EQ(parallel[0].crosses, x < 1);
      expect_margin(parallel[0].margin, e / (x + 1));
    }
    // Towards an edge: in through z at t = 3, out through x at t = 3 (1 + e).
    const auto corner = doubts_of(box, {V(1 - 3 * (1 + e), 0, -4), V(1, 0, 1)});
    ASSERT_EQ(corner.size(), 2u);
    EXPECT_NEAR(corner[0].margin, 3 * e / (6 + 3 * e), 1e-15);
  }
}

TEST(Doubt, FlatThingsArePassedByTheirRims) {
  const Disc<double> disc{{V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)}, 1, 0};
  const Parallelogram<double> quad{{V(-1, -1, 0), V(1, -1, 0), V(1, 1, 0), V(-1, 1, 0)}, false};
  for (int k = 2; k <= kFinest; ++k) {
    for (const int sign : {-1, 1}) {
      const double r = 1 + sign * std::ldexp(1, -k), off = std::abs((1 - r) * (1 + r));
      const Ray<double> ray{V(r, 0, -4), V(0, 0, 2)};
      const auto on_disc = doubts_of(disc, ray);
      EXPECT_EQ(on_disc[0].crosses, sign < 0);
      // The disc compares rounded squares: half an ulp of 1, of 19.
      EXPECT_NEAR(on_disc[0].margin, off / (r * r + 1 + r * r + 16), 0x1p-53);
      const auto on_quad = doubts_of(quad, ray);
      EXPECT_EQ(on_quad[0].crosses, sign < 0);
      const double farthest = std::sqrt((1 + r) * (1 + r) + 1 + 16);
      expect_margin(on_quad[0].margin, std::abs(1 - r) / farthest);
    }
  }
}

TEST(Doubt, PlaneIsMissedByTheSineOfTheAngle) {
  const Plane<double> plane{V(0, 1, 0), 0, V(1, 0, 0), V(0, 0, 1), 0, 0};
  for (int k = 2; k <= kFinest; ++k) {
    const double e = std::ldexp(1, -k);
    const auto down = doubts_of(plane, {V(0, 2, 0), V(0, -e, 1)});
    ASSERT_EQ(down.size(), 1u);
    EXPECT_TRUE(down[0].crosses);
    expect_margin(down[0].margin, e / std::sqrt(1 + e * e));
    const auto up = doubts_of(plane, {V(0, 2, 0), V(0, e, 1)});
    ASSERT_EQ(up.size(), 2u);
    EXPECT_FALSE(up[1].crosses);
    EXPECT_EQ(up[1].t, 2 / e);
    expect_margin(up[1].margin, e / std::sqrt(1 + e * e));
  }
}

// Where a doubt crosses, the kernel does, at the same t to the last bit.
TEST(Doubt, CrossingsAreThoseOfTheKernels) {
  const Sphere<double> ball{V(0.1, 0.2, 0.3), 1.1};
  const Box<double> box{V(-1, -0.8, -0.7), V(0.9, 1, 1.1)};
  const Frustum<double> cone{
      {V(0, -1, 0), V(1, 0, 0), V(0, 0, 1), V(0, 1, 0)}, 2, 0.2, 1.2, 0.5, true, true};
  const Frustum<double> tube{
      {V(0, -1, 0), V(1, 0, 0), V(0, 0, 1), V(0, 1, 0)}, 2, 0.9, 0.9, 0, false, true};
  const Disc<double> ring{{V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)}, 1.4, 0.3};
  const Triangle<double> triangle{{V(-1, -1, 0), V(1.5, -1, 0.2), V(0, 1.5, -0.3)}};
  const Parallelogram<double> quad{{V(-1, -1, 0), V(1, -1, 0.5), V(1, 1, 0.5), V(-1, 1, 0)}, false};
  const auto expect_same = [](const auto& shape, const Ray<double>& ray) {
    std::vector<double> from_doubts, from_kernel;
    for (const Doubt<double>& d : doubts_of(shape, ray)) {
      if (d.crosses) from_doubts.push_back(d.t);
    }
    for (const Crossing<double>& c : crossings(shape, ray, Departure()))
      from_kernel.push_back(c.t);
    EXPECT_EQ(from_doubts, from_kernel);
    return from_kernel.size();
  };
  std::size_t found = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto number = [i](int j) {
      return std::remainder(0.618034 * (i + 1) * (2 * j + 1), 1.0);
    };
    const V from(6 * number(0), 6 * number(1), 6 * number(2));
    const V to(2 * number(3), 2 * number(4), 2 * number(5));
    const Ray<double> ray{from, to - from};
    found += expect_same(ball, ray) + expect_same(box, ray) + expect_same(cone, ray) +
             expect_same(tube, ray) + expect_same(ring, ray) + expect_same(triangle, ray) +
             expect_same(quad, ray);
  }
  EXPECT_GT(found, 10000u);
}

}  // namespace
}  // namespace alhazen::render
