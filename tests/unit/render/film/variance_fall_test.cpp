#include "render/film/variance_fall.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/math/random.h"

namespace alhazen::render {
namespace {

// `pixels` pixels doubled to `level`, whose squares are noise about outer 1 and inner `factor`.
void measure(VarianceFall& fall, int level, double factor, int pixels) {
  for (int p = 0; p < pixels; ++p) {
    const Sample2d at =
        sample_2d(mix_64(7, static_cast<std::uint64_t>(level)), static_cast<std::uint32_t>(p));
    fall.add(level, 1, 2 * unit_real<double>(at.x), 2 * factor * unit_real<double>(at.y));
  }
  fall.settle();
}

TEST(VarianceFall, IsThatOfRandomSamplingUntilItIsMeasured) {
  VarianceFall fall;
  fall.settle();
  for (int level = 0; level < kSampleLevels; ++level)
    EXPECT_EQ(fall.factor(level), 2);
}

// The mean of N uniform values on (0, 2) has the relative variance 1 / (3 N): of the ratio twice
// that.
TEST(VarianceFall, IsMeasuredWithItsDoubt) {
  for (const double factor : {2.2, 2.6}) {
    VarianceFall fall;
    measure(fall, 3, factor, 4096);
    const double error = factor * std::sqrt(2.0 / 3 / 4096);
    EXPECT_NEAR(fall.factor(3), factor, 3 * error) << factor;
    EXPECT_NEAR(fall.doubt(3), error / (factor - 1), 0.2 * error) << factor;
  }
}

TEST(VarianceFall, IsBetweenRandomSamplingAndEdges) {
  VarianceFall fall;
  measure(fall, 2, 1.2, 4096);
  measure(fall, 3, 9, 4096);
  EXPECT_EQ(fall.factor(2), 2);
  EXPECT_DOUBLE_EQ(fall.factor(3), std::pow(2.0, 1.5));
}

// What few pixels say counts less than what is known beforehand.
TEST(VarianceFall, FewPixelsAreBelievedLess) {
  VarianceFall few, many;
  measure(few, 2, 2.7, 4);
  measure(many, 2, 2.7, 400);
  EXPECT_LT(few.factor(2), many.factor(2));
  EXPECT_GT(few.doubt(2), many.doubt(2));
}

// Those that were chosen count once and have large squares, those that stand for many have small
// ones. All say the same, so there is no doubt about it.
TEST(VarianceFall, IsOneForAllWhateverTheyCount) {
  VarianceFall fall;
  for (int p = 0; p < 20; ++p)
    fall.add(2, 1, 4 + p, 2.5 * (4 + p));
  for (int p = 0; p < 5; ++p)
    fall.add(2, 8, 0.01, 0.025);
  fall.settle();
  EXPECT_NEAR(fall.factor(2), 2.5, 1e-12);
  EXPECT_LT(fall.doubt(2), 1e-6);
}

// Two numbers of one pixel have no spread to judge them by.
TEST(VarianceFall, OnePixelSaysNothing) {
  VarianceFall fall, none;
  fall.add(2, 1, 1, 2.7);
  fall.settle();
  none.settle();
  EXPECT_EQ(fall.factor(2), 2);
  EXPECT_EQ(fall.doubt(2), none.doubt(2));
}

}  // namespace
}  // namespace alhazen::render
