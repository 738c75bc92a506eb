// tests: what a pixel makes of its samples (docs/numerics.md J1, J2).
#include <random>

#include "core/math/random.h"
#include "render/film/pixel_accumulator.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

constexpr FilterKind kKinds[] = {FilterKind::box, FilterKind::tent, FilterKind::gaussian,
                                 FilterKind::mitchell};

// Gathers `samples` (0,2) samples of a picture given as a function of the place.
template <class Picture>
PixelAccumulator<1> gathered(const Filter& filter, int samples, std::uint64_t seed,
                             Picture picture) {
  PixelAccumulator<1> pixel;
  for (int i = 0; i < samples; ++i) {
    const Sample2d s = sample_2d(seed, static_cast<std::uint32_t>(i));
    const auto at = filter.sample(unit_real<double>(s.x), unit_real<double>(s.y));
    pixel.add({picture(at.x, at.y)}, at.negative);
  }
  return pixel;
}

TEST(Accumulator, AConstantPictureIsConstant) {
  Worst worst("J1: 0.1 over 1..65536 samples, every filter", 1, "ulp of float");
  for (const FilterKind kind : kKinds) {
    const Filter filter({kind, usual_radius(kind)});
    for (int samples = 1; samples <= 65536; samples = samples * 4 - samples % 4 + 1) {
      for (const double value : {0.1, 1e-30, 1e30}) {
        const auto pixel = gathered(filter, samples, 9, [&](double, double) { return value; });
        const float mean = static_cast<float>(pixel.mean(filter)[0]);
        const float exact = static_cast<float>(value);
        const float ulp = std::nextafter(exact, 2 * exact) - exact;
        worst.add(static_cast<double>(std::fabs(mean - exact) / ulp));
        EXPECT_EQ(pixel.standard_error(filter), 0);
      }
    }
  }
}

// N (0,2) samples have one in each of N columns: an edge along an axis is wrong in the one column
// that it cuts, by at most 1/N. A slanted edge cuts about 2 sqrt(N) cells, each at random:
// N^(-3/4).
TEST(Accumulator, TheEdgeOfAHalfPlane) {
  const Filter box({FilterKind::box, 0.5});
  Worst axis("J2: |coverage - f| N, edges along an axis", 1), slant("J2: slanted, N^(3/4)", 1);
  for (const int samples : {16, 64, 256, 1024, 4096}) {
    for (const double f : {0.1, 0.37, 0.5, 0.81}) {
      const auto pixel =
          gathered(box, samples, 3, [&](double x, double) { return x < f - 0.5 ? 1.0 : 0.0; });
      axis.add(std::fabs(pixel.mean(box)[0] - f) * samples);
      // The half plane below the line through the centre at any slope covers 1/2.
      const auto half =
          gathered(box, samples, 4, [&](double x, double y) { return y < 3 * f * x ? 1.0 : 0.0; });
      slant.add(std::fabs(half.mean(box)[0] - 0.5) * std::pow(samples, 0.75));
    }
  }
}

// z-test: the mean over many seeds is the coverage under the filter, to 4 standard errors.
TEST(Accumulator, EdgesAreUnbiasedUnderEveryFilter) {
  for (const FilterKind kind : kKinds) {
    const Filter filter({kind, usual_radius(kind)});
    const FilterProfile profile(kind, usual_radius(kind));
    const double edge = 0.23;
    // 1/2 and the integral from 0 to the edge, which no knot of the filters cuts.
    const double expected =
        0.5 + test::integral(0, edge, 64, [&](double x) { return profile.value(x); });
    RunningMoments<1> means;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
      const auto pixel = gathered(filter, 64, mix_64(seed, 77),
                                  [&](double x, double) { return x < edge ? 1.0 : 0.0; });
      means.add({pixel.mean(filter)[0]});
    }
    const double error = std::sqrt(means.variance_of_mean(0));
    EXPECT_LT(std::fabs(means.mean(0) - expected), 4 * error + 1e-12) << static_cast<int>(kind);
    EXPECT_LT(error, 1e-3);
  }
}

// A linear ramp keeps its value at the centre of the pixel: 0 here. Quadrature over the two sides
// of the distribution is exact, since its quantiles are mirrored.
TEST(Accumulator, ALinearRampIsReconstructed) {
  Worst worst("ramp through the pixel's centre", 1e-13);
  for (const FilterKind kind : kKinds) {
    const Filter filter({kind, usual_radius(kind)});
    PixelAccumulator<1> pixel;
    constexpr int kSide = 64;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const auto s = filter.sample((i + 0.5) / kSide, (j + 0.5) / kSide);
        pixel.add({7 + 2 * s.x - 3 * s.y}, s.negative);
      }
    }
    worst.add(std::fabs(pixel.mean(filter)[0] - 7));
  }
}

TEST(Accumulator, TheStandardErrorIsTheSpreadOfTheMean) {
  // Independent samples, as the estimate assumes; a picture of noise.
  for (const FilterKind kind : {FilterKind::box, FilterKind::mitchell}) {
    const Filter filter({kind, usual_radius(kind)});
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    RunningMoments<1> means, errors;
    for (int pixel = 0; pixel < 4000; ++pixel) {
      PixelAccumulator<2> sum;
      for (int i = 0; i < 64; ++i) {
        const auto s = filter.sample(unit(random), unit(random));
        sum.add({unit(random), 100 * unit(random)}, s.negative);
      }
      means.add({sum.mean(filter)[0]});
      errors.add({sum.standard_error(filter, 1)});
    }
    const double spread = std::sqrt(means.variance_of_mean(0) * means.count());
    EXPECT_NEAR(errors.mean(0) / spread, 1, 0.1);
  }
}

TEST(Accumulator, OneSignAloneIsItsMean) {
  const Filter filter({FilterKind::mitchell, 2});
  PixelAccumulator<1> positive, negative, empty;
  positive.add({3}, false);
  negative.add({3}, true);
  EXPECT_EQ(positive.mean(filter)[0], 3);
  EXPECT_EQ(negative.mean(filter)[0], 3);
  EXPECT_EQ(empty.mean(filter)[0], 0);
  EXPECT_EQ(positive.count(), 1u);
  EXPECT_EQ(positive.standard_error(filter), 0);
}

TEST(RunningMoments, MeanAndVarianceOfAShortStream) {
  RunningMoments<1> moments;
  for (const double x : {1.0, 2.0, 3.0, 6.0})
    moments.add({x});
  EXPECT_EQ(moments.mean(0), 3);
  EXPECT_NEAR(moments.variance_of_mean(0), 14.0 / 3 / 4, 1e-15);
}

}  // namespace
}  // namespace alhazen::render
