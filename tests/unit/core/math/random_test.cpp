#include "core/math/random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace alhazen {
namespace {

TEST(Random, ScramblesAreBijections) {
  std::set<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    seen.insert(owen_scrambled(i << 20, 0x12345678u) >> 20);
    EXPECT_EQ(reversed_bits(reversed_bits(i * 0x9e3779b9u)), i * 0x9e3779b9u);
  }
  // Owen: the top 12 bits of the result depend on the top 12 bits of the input alone, one to one.
  EXPECT_EQ(seen.size(), 4096u);
}

// The digits of Sobol's second dimension by its direction numbers, one for each bit of the index.
std::uint32_t sobol_second_by_directions(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 0x80000000u; index != 0; index >>= 1) {
    if ((index & 1u) != 0) result ^= direction;
    direction ^= direction >> 1;
  }
  return result;
}

// Both are linear over bits, so agreeing for each single bit is agreeing for all; sums of bits
// check that they are.
TEST(Random, SobolsSecondDimensionHasItsDirections) {
  for (int bit = 0; bit < 32; ++bit) {
    const std::uint32_t index = 1u << bit;
    EXPECT_EQ(reversed_bits(sobol_second_upward(index)), sobol_second_by_directions(index)) << bit;
  }
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const auto index = static_cast<std::uint32_t>(mix_64(i));
    ASSERT_EQ(reversed_bits(sobol_second_upward(index)), sobol_second_by_directions(index));
  }
}

// The samples that pictures have been made of, which no faster way of drawing them may change.
TEST(Random, SamplesAreThoseOfTheDefinition) {
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const std::uint64_t seed = mix_64(9, i), first = mix_64(seed, 1), second = mix_64(seed, 2);
    const auto index = static_cast<std::uint32_t>(i % 2 == 0 ? i : mix_64(i));
    const std::uint32_t shuffled = owen_scrambled(index, static_cast<std::uint32_t>(first));
    const Sample2d drawn = sample_2d(seed, index);
    ASSERT_EQ(drawn.x,
              owen_scrambled(reversed_bits(shuffled), static_cast<std::uint32_t>(first >> 32)));
    ASSERT_EQ(drawn.y, owen_scrambled(sobol_second_by_directions(shuffled),
                                      static_cast<std::uint32_t>(second)));
  }
}

// Every prefix of 2^m samples puts exactly one into each of the m + 1 tilings by 2^m equal boxes.
TEST(Random, PrefixesFillElementaryIntervals) {
  for (std::uint64_t seed : {0ULL, 1ULL, 0xdeadbeefULL, ~0ULL}) {
    for (int m = 0; m <= 12; ++m) {
      const std::uint32_t count = 1u << m;
      for (int columns = 0; columns <= m; ++columns) {
        std::vector<int> hits(count, 0);
        for (std::uint32_t i = 0; i < count; ++i) {
          const Sample2d p = sample_2d(seed, i);
          const std::uint64_t column = (std::uint64_t{p.x} << columns) >> 32;
          const std::uint64_t row = (std::uint64_t{p.y} << (m - columns)) >> 32;
          ++hits[(row << columns) | column];
        }
        for (const int n : hits)
          ASSERT_EQ(n, 1) << "seed " << seed << " m " << m;
      }
    }
  }
}

TEST(Random, OneDimensionIsStratified) {
  for (int m = 0; m <= 12; ++m) {
    std::set<std::uint64_t> strata;
    for (std::uint32_t i = 0; i < (1u << m); ++i) {
      strata.insert((std::uint64_t{sample_1d(42, i)} << m) >> 32);
    }
    EXPECT_EQ(strata.size(), std::size_t{1} << m);
  }
}

// Neighbouring seeds give independent first samples: chi-square of (x_s, x_{s+1}, y_s) over 8^3
// cells, 511 degrees of freedom. 5 sigma of the normal limit: 511 + 5 sqrt(2 * 511) < 672.
TEST(Random, SeedsAreIndependent) {
  const int seeds = 512 * 64;
  for (const std::uint32_t index : {0u, 1u, 17u}) {
    std::vector<int> cells(512, 0);
    for (int s = 0; s < seeds; ++s) {
      const auto seed = static_cast<std::uint64_t>(s);
      const Sample2d a = sample_2d(seed, index), b = sample_2d(seed + 1, index);
      ++cells[((a.x >> 29) << 6) | ((b.x >> 29) << 3) | (a.y >> 29)];
    }
    double chi_square = 0;
    for (const int n : cells)
      chi_square += (n - 64.0) * (n - 64.0) / 64.0;
    EXPECT_LT(chi_square, 672) << index;
    EXPECT_GT(chi_square, 350) << index;  // too even would be dependence, too
  }
}

// Two sequences paired by index are not correlated: the correlation of N pairs of independent
// stratified sequences is within 5 / sqrt(N).
TEST(Random, SequencesOfDifferentSeedsDoNotCorrelate) {
  const int count = 1024;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const double a = unit_real<double>(sample_2d(seed, i).x) - 0.5;
      const double b = unit_real<double>(sample_2d(seed + 1, i).x) - 0.5;
      sum += a * b;
    }
    EXPECT_LT(std::fabs(sum / count * 12), 5 / std::sqrt(double{count})) << seed;
  }
}

TEST(Random, EveryScalarTypeDrawsTheSameNumber) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t bits = sample_1d(3, i);
    EXPECT_EQ(static_cast<double>(unit_real<float>(bits)), unit_real<double>(bits));
#if ALHAZEN_HAS_QUAD
    EXPECT_TRUE(unit_real<Quad>(bits) == static_cast<Quad>(unit_real<double>(bits)));
#endif
  }
  EXPECT_EQ(unit_real<float>(0), 0.0f);
  EXPECT_LT(unit_real<float>(0xffffffffu), 1.0f);
}

}  // namespace
}  // namespace alhazen
