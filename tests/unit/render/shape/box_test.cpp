#include "render/shape/box.h"

#include <gtest/gtest.h>

#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

const Box<double> kBox{{-1, -2, -3}, {1, 2, 3}};

TEST(Box, ClosedForms) {
  const Ray<double> ray{{0.5, -1, -7}, {0, 0, 2}};
  const auto hits = crossings(kBox, ray, Departure());
  ASSERT_EQ(hits.size(), 2);
  EXPECT_EQ(hits[0].t, 2);
  EXPECT_EQ(hits[0].face, 4);
  EXPECT_EQ(hits[1].t, 5);
  EXPECT_EQ(hits[1].face, 5);
  const auto point = surface(kBox, ray, hits[0]);
  EXPECT_EQ(point.position, Vec3d(0.5, -1, -3));
  EXPECT_EQ(point.normal, Vec3d(0, 0, -1));
  EXPECT_EQ(point.u, 0.75);
  EXPECT_EQ(point.v, 0.25);
}

// A6: origins in the planes of faces, directions along axes, zeros of either sign.
TEST(Box, SignedZerosAgreeAndMakeNoNaN) {
  const double coordinates[] = {-4, -3, -2, -1, 0, 1, 2, 3, 4};
  for (const double x : coordinates) {
    for (const double y : coordinates) {
      for (const double sign : {1.0, -1.0}) {
        const auto plus = crossings(kBox, {{x, y, -5}, {0.0, 0.0, sign}}, Departure());
        const auto minus = crossings(kBox, {{x, y, -5}, {-0.0, -0.0, sign}}, Departure());
        const bool inside = std::fabs(x) <= 1 && std::fabs(y) <= 2;
        ASSERT_EQ(plus.size(), inside && sign > 0 ? 2 : 0) << x << ' ' << y;
        ASSERT_EQ(minus.size(), plus.size());
        for (int i = 0; i < plus.size(); ++i)
          EXPECT_EQ(plus[i].t, minus[i].t);
      }
    }
  }
}

TEST(Box, LeavingAFace) {
  const Ray<double> inward{{1, 0, 0}, {-1, 0, 0}}, outward{{1, 0, 0}, {1, 0, 0}};
  const auto across = crossings(kBox, inward, Departure{1});
  ASSERT_EQ(across.size(), 1);
  EXPECT_EQ(across[0].t, 2);
  EXPECT_EQ(across[0].face, 0);
  EXPECT_EQ(crossings(kBox, outward, Departure{1}).size(), 0);
  // Held inside by its side though rounding points it out: out again at once.
  const auto held = crossings(kBox, outward, Departure{1, Side::kBelow});
  ASSERT_EQ(held.size(), 1);
  EXPECT_EQ(held[0].t, 0);
}

TEST(Box, Contains) {
  EXPECT_TRUE(contains(kBox, Vec3d{0.9, 1.9, 2.9}));
  EXPECT_FALSE(contains(kBox, Vec3d{1, 0, 0}));
  EXPECT_FALSE(contains(kBox, Vec3d{0, -2.1, 0}));
}

}  // namespace
}  // namespace alhazen::render
