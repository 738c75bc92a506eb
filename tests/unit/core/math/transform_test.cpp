#include "core/math/transform.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/hash.h"

namespace alhazen {
namespace {

double uniform(std::uint64_t i) {
  return static_cast<double>(mix_64(i) >> 11) * 0x1p-52 - 1;
}

Affined random_map(std::uint64_t seed) {
  Affined map;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j)
      map.rows[i][j] = uniform(mix_64(seed, 4 * i + j));
  }
  return map;
}

double largest_entry(const Affined& map) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j)
      largest = std::max(largest, std::fabs(map.rows[i][j]));
  }
  return largest;
}

TEST(Transform, InverseUndoes) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Affined map = random_map(seed);
    const auto back = inverse(map);
    ASSERT_TRUE(back.has_value());
    const Affined product = *back * map;
    // Cofactors are exact to 2u each; the determinant, the quotient and the product add at most a
    // few more, each relative to |back| |map|: 16 u per unit of that product, three terms each.
    const double bound = 48 * 0x1p-53 * largest_entry(*back) * largest_entry(map);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) {
        EXPECT_NEAR(product.rows[i][j], i == j ? 1 : 0, bound) << "seed " << seed;
      }
    }
  }
}

TEST(Transform, InverseCommutesWithPowersOfTwo) {
  for (const int k : {-300, -100, -1, 1, 100, 300}) {
    const double s = std::ldexp(1.0, k);
    const Affined map = random_map(7);
    Affined scaled_map = map;
    for (auto& row : scaled_map.rows) {
      for (double& entry : row)
        entry *= s;
    }
    const auto plain = inverse(map), scaled = inverse(scaled_map);
    ASSERT_TRUE(plain && scaled) << k;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        EXPECT_EQ(scaled->rows[i][j] * s, plain->rows[i][j]);
      EXPECT_EQ(scaled->rows[i][3], plain->rows[i][3]);
    }
  }
}

TEST(Transform, SingularAtEveryScale) {
  for (int k = -300; k <= 300; k += 50) {
    const double s = std::ldexp(1.0, k);
    EXPECT_TRUE(inverse(scaling({s, s, s})).has_value()) << k;
    EXPECT_FALSE(inverse(scaling({s, 0, s})).has_value()) << k;
    // Third column = first + second, with rounding: rank two to working precision.
    Affined map = random_map(k + 1000);
    for (auto& row : map.rows) {
      for (int j = 0; j < 2; ++j)
        row[j] *= s;
      row[2] = row[0] + row[1];
    }
    EXPECT_FALSE(inverse(map).has_value()) << k;
  }
  EXPECT_FALSE(inverse(scaling({std::nan(""), 1, 1})).has_value());
  EXPECT_FALSE(inverse(scaling({INFINITY, 1, 1})).has_value());
}

TEST(Transform, UnevenScalesAreNotSingular) {
  const auto back = inverse(scaling({0x1p-200, 1, 0x1p200}));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(*back, scaling({0x1p200, 1, 0x1p-200}));
}

TEST(Transform, QuarterTurnsAreExact) {
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(rotation(z, 90).vector(x), y);
  EXPECT_EQ(rotation(x, 90).vector(y), z);
  EXPECT_EQ(rotation(y, 90).vector(z), x);
  for (const Vec3d axis : {x, y, z, Vec3d{0, 0x1p300, 0}, Vec3d{-0x1p-300, 0, 0}}) {
    const Affined quarter = rotation(axis, 90);
    EXPECT_EQ(quarter * quarter, rotation(axis, 180));
    EXPECT_EQ(quarter * quarter * quarter, rotation(axis, -90));
    EXPECT_EQ(quarter * quarter * quarter * quarter, Affined());
    EXPECT_EQ(rotation(axis, 360000090), quarter);
  }
}

TEST(Transform, RotationKeepsLengths) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vec3d axis{uniform(3 * i), uniform(3 * i + 1), uniform(3 * i + 2)};
    const Affined map = rotation(axis, 1000 * uniform(i));
    // Entries err by at most 4u (two products, two sums of values below 1), so the columns' dot
    // products by at most 3 * 2 * 4 u.
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        double sum = 0;
        for (int row = 0; row < 3; ++row)
          sum += map.rows[row][a] * map.rows[row][b];
        EXPECT_NEAR(sum, a == b ? 1 : 0, 24 * 0x1p-53);
      }
    }
  }
}

TEST(Transform, NormalsStayPerpendicular) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Affined world_from_object = random_map(seed);
    const auto object_from_world = inverse(world_from_object);
    const Vec3d u{uniform(seed), uniform(seed + 1), 0.5}, v{uniform(seed + 2), 0.25, uniform(seed)};
    const Vec3d n = object_from_world->transposed(cross(u, v));
    const double size = largest_entry(*object_from_world) * largest_entry(world_from_object);
    EXPECT_NEAR(dot(n, world_from_object.vector(u)), 0, 128 * 0x1p-53 * size);
  }
}

}  // namespace
}  // namespace alhazen
