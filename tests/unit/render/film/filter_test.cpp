// tests: reconstruction filters: their integrals, the distribution of their samples, and what they
// reconstruct.
#include "render/film/filter.h"

#include <random>

#include "core/math/elementary.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

constexpr FilterKind kKinds[] = {FilterKind::box, FilterKind::tent, FilterKind::gaussian,
                                 FilterKind::mitchell};
const char* name_of(FilterKind kind) {
  constexpr const char* kNames[] = {"box", "tent", "gaussian", "mitchell"};
  return kNames[static_cast<std::size_t>(kind)];
}

// The integral over [-r, r] of g(x) times the profile, in pieces that respect its knots.
template <class Function>
double integral_with(const FilterProfile& profile, double radius, Function g) {
  double sum = 0;
  const double knots[] = {-1, -4.0 / 7, -0.5, 0, 0.5, 4.0 / 7, 1};
  for (int i = 0; i < 6; ++i) {
    sum += test::integral(radius * knots[i], radius * knots[i + 1], 64,
                          [&](double x) { return g(x) * profile.value(x); });
  }
  return sum;
}

TEST(FilterProfile, HasIntegralOneAndItsParts) {
  Worst one("filter: integral - 1", 1e-14), parts("filter: |f| - (P + N)", 1e-14);
  for (const FilterKind kind : kKinds) {
    for (const double radius : {0.5, 1.0, usual_radius(kind), 3.7}) {
      const FilterProfile profile(kind, radius);
      one.add(std::fabs(integral_with(profile, radius, [](double) { return 1.0; }) - 1));
      const double absolute_integral = integral_with(
          profile, radius, [&](double x) { return profile.value(x) < 0 ? -1.0 : 1.0; });
      parts.add(
          std::fabs(absolute_integral - profile.positive_integral() - profile.negative_integral()));
      EXPECT_NEAR(profile.positive_integral() - profile.negative_integral(), 1, 0x1p-52);
    }
  }
}

TEST(FilterProfile, ValuesAreThoseOfTheirFormulas) {
  Worst gaussian("gaussian: |interpolant - exact| / peak", 3e-9), mitchell("mitchell", 1e-15);
  const FilterProfile g(FilterKind::gaussian, 1.5), m(FilterKind::mitchell, 2);
  const auto exact_gaussian = [](double x) { return std::exp(-2 * x * x) - std::exp(-4.5); };
  const double norm = 2 * test::integral(0, 1.5, 8, exact_gaussian);
  const auto exact_mitchell = [](long double x) {
    const long double inner = 7 * x * x * x - 12 * x * x + 16.0L / 3;
    const long double outer = -7.0L / 3 * x * x * x + 12 * x * x - 20 * x + 32.0L / 3;
    return static_cast<double>((x < 1 ? inner : outer) / 6);
  };
  for (int i = 0; i <= 1000; ++i) {
    const double x = 1.5 * i / 1000, y = 2.0 * i / 1000;
    gaussian.add(std::fabs(g.value(x) - exact_gaussian(x) / norm) / g.value(0));
    mitchell.add(std::fabs(m.value(y) - exact_mitchell(y)));
    EXPECT_EQ(m.value(y), m.value(-y));
  }
  EXPECT_NEAR(m.value(0), 8.0 / 9, 1e-15);
  EXPECT_EQ(FilterProfile(FilterKind::tent, 1).value(0.25), 0.75);
  EXPECT_EQ(FilterProfile(FilterKind::box, 0.5).value(0.25), 1);
  EXPECT_EQ(g.value(1.6), 0);
}

// Box, tent and Mitchell of their usual radius sum to 1 over the pixels, wherever one looks.
TEST(FilterProfile, PartitionOfUnity) {
  Worst worst("sum over pixels - 1", 1e-14);
  for (const FilterKind kind : {FilterKind::box, FilterKind::tent, FilterKind::mitchell}) {
    const FilterProfile profile(kind, usual_radius(kind));
    for (double x = 0.013; x < 1; x += 0.05) {
      double sum = 0;
      for (int pixel = -3; pixel <= 3; ++pixel)
        sum += profile.value(x - pixel);
      worst.add(std::fabs(sum - 1));
    }
  }
}

// quantile() undoes the distribution function: the integral of |f| up to it is u.
TEST(FilterProfile, QuantilesAreExact) {
  for (const FilterKind kind : kKinds) {
    Worst worst(std::string("distribution(quantile(u)) - u, ") + name_of(kind), 2e-15);
    const double radius = usual_radius(kind);
    const FilterProfile profile(kind, radius);
    const double whole = profile.positive_integral() + profile.negative_integral();
    const auto mass_below = [&](double x) {
      // From the centre: pieces up to each knot and the rest.
      double sum = 0, from = 0;
      const double distance = std::fabs(x);
      for (const double knot : {0.5 * radius, 4.0 / 7 * radius, radius}) {
        const double to = smaller(knot, distance);
        if (to > from) {
          sum +=
              test::integral(from, to, 128, [&](double s) { return std::fabs(profile.value(s)); });
          from = to;
        }
      }
      return 0.5 + (x < 0 ? -sum : sum) / whole;
    };
    double before = -infinity<double>();
    for (int i = 0; i <= 64; ++i) {
      const double u = i / 64.0, x = profile.quantile(u);
      EXPECT_GT(x, before);
      before = x;
      worst.add(std::fabs(mass_below(x) - u));
    }
    // Mitchell's lobes touch 0 at the border like a square: the last 1e-16 of their integral lies
    // within the cube root of that.
    EXPECT_NEAR(profile.quantile(1), radius, 1e-4);
    EXPECT_LE(profile.quantile(1), radius);
    EXPECT_EQ(profile.quantile(0.5), 0);
    EXPECT_EQ(profile.quantile(0.25), -profile.quantile(0.75));
  }
}

// Pearson's chi-square of 10^6 random samples in 64 bins against the integral of |f| in each.
TEST(Filter, SamplesAreDistributedAsItsAbsoluteValue) {
  for (const FilterKind kind : kKinds) {
    constexpr int kBins = 64, kDraws = 1000000;
    const double radius = usual_radius(kind);
    const FilterProfile profile(kind, radius);
    const double whole = profile.positive_integral() + profile.negative_integral();
    std::array<int, kBins> counts{};
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < kDraws; ++i) {
      const double x = profile.quantile(unit(random));
      ++counts[static_cast<std::size_t>(smaller(kBins - 1, int((x / radius + 1) / 2 * kBins)))];
      ASSERT_TRUE(profile.is_negative(x) == (profile.value(x) < 0) || profile.value(x) == 0);
    }
    double chi_square = 0;
    for (int bin = 0; bin < kBins; ++bin) {
      const double low = (2.0 * bin / kBins - 1) * radius, step = 2 * radius / kBins;
      const double expected = kDraws / whole * test::integral(low, low + step, 16, [&](double x) {
                                return std::fabs(profile.value(x));
                              });
      const double off = counts[static_cast<std::size_t>(bin)] - expected;
      chi_square += off * off / expected;
    }
    // 63 degrees of freedom: 103.4 is passed with probability 0.001.
    std::printf("    %s: chi-square %.1f (bound 103.4)\n", name_of(kind), chi_square);
    EXPECT_LT(chi_square, 103.4);
  }
}

TEST(Filter, SignsAndPartsAgree) {
  const Filter filter({FilterKind::mitchell, 2});
  int negative = 0;
  constexpr int kSide = 1024;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const auto s = filter.sample((i + 0.5) / kSide, (j + 0.5) / kSide);
      negative += s.negative;
      ASSERT_TRUE(filter.value(s.x, s.y) == 0 || (filter.value(s.x, s.y) < 0) == s.negative);
    }
  }
  const double whole = filter.positive_integral() + filter.negative_integral();
  EXPECT_NEAR(negative / double{kSide} / kSide, filter.negative_integral() / whole, 4.0 / kSide);
  EXPECT_NEAR(filter.positive_integral() - filter.negative_integral(), 1, 1e-15);
  EXPECT_EQ(Filter({FilterKind::gaussian, 1.5}).negative_integral(), 0);
}

}  // namespace
}  // namespace alhazen::render
