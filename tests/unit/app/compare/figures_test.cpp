#include "app/compare/figures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <vector>

namespace alhazen {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Figures of(const std::vector<float>& a, const std::vector<float>& b, Tolerance tolerance = {},
           double peak = 1.0) {
  return FigureSums(a, b, 2, tolerance).figures(peak);
}

// Every number is a small fraction, so that the sums are exact; the last bit of a quotient is not.
TEST(Figures, OfFourPixelsByHand) {
  const Figures figures = of({1.0F, 0.5F, 0.25F, 2.0F}, {1.0F, 0.0F, 0.5F, 3.0F});
  EXPECT_EQ(figures.pairs, 4u);
  EXPECT_EQ(figures.compared, 4u);
  EXPECT_EQ(figures.mse, (0.25 + 0.0625 + 1.0) / 4.0);
  EXPECT_EQ(figures.rmse, std::sqrt(figures.mse));
  EXPECT_DOUBLE_EQ(figures.relative_mse, (0.25 / 0.01 + 0.0625 / 0.26 + 1.0 / 9.01) / 4.0);
  EXPECT_EQ(figures.mae, (0.5 + 0.25 + 1.0) / 4.0);
  EXPECT_EQ(figures.largest.error, 1.0);
  EXPECT_EQ(figures.largest.place, (PixelPlace{1, 1}));
  EXPECT_EQ(figures.largest.a, 2.0);
  EXPECT_EQ(figures.largest.b, 3.0);
  EXPECT_EQ(figures.over, 3u);
}

TEST(Figures, PsnrIsInDecibelsBelowThePeak) {
  EXPECT_DOUBLE_EQ(of({0.1F}, {0.0F}).psnr, 20.0 * std::log10(1.0 / double(0.1F)));
  // Ten times the peak is 20 dB more.
  EXPECT_DOUBLE_EQ(of({0.5F}, {0.0F}, {}, 10.0).psnr, of({0.5F}, {0.0F}).psnr + 20.0);
  EXPECT_EQ(of({0.5F, 3.0F}, {0.5F, 3.0F}).psnr, std::numeric_limits<double>::infinity());
}

TEST(Figures, ChannelsPoolToTheFiguresOfAllTheirPixels) {
  const std::vector<float> a{1, 2, 3, 4}, b{1, 3, 1, 4}, c{9, 2, kNan, 1}, d{3, 2, 5, 1};
  FigureSums sums(a, b, 2, {});
  sums.add(FigureSums(c, d, 2, {}));
  const Figures pooled = sums.figures(1.0);
  EXPECT_EQ(pooled.compared, 7u);
  EXPECT_EQ(pooled.mse, (0.0 + 1.0 + 4.0 + 0.0 + 36.0 + 0.0 + 0.0) / 7.0);
  EXPECT_EQ(pooled.largest.error, 6.0);
  EXPECT_EQ(pooled.largest.place, (PixelPlace{0, 0}));
  EXPECT_EQ(pooled.over, 4u);
  EXPECT_EQ(pooled.odd_count(OddPair::nan_in_a).count, 1u);
  EXPECT_EQ(pooled.odd_count(OddPair::nan_in_a).first, (PixelPlace{0, 1}));
}

TEST(Figures, OddPairsAreCountedByKindAndLeftOutOfTheMeans) {
  const std::vector<float> a{kNan, 1.0F, kNan, kInfinity, kInfinity, 2.0F, -kInfinity, 0.0F};
  const std::vector<float> b{1.0F, kNan, kNan, kInfinity, 5.0F, 2.5F, kInfinity, 0.0F};
  const Figures figures = of(a, b);
  EXPECT_EQ(figures.odd_count(OddPair::nan_in_a).count, 1u);
  EXPECT_EQ(figures.odd_count(OddPair::nan_in_b).first, (PixelPlace{1, 0}));
  EXPECT_EQ(figures.odd_count(OddPair::nan_in_both).first, (PixelPlace{0, 1}));
  EXPECT_EQ(figures.odd_count(OddPair::equal_infinity).first, (PixelPlace{1, 1}));
  EXPECT_EQ(figures.odd_count(OddPair::unequal_infinity).count, 2u);
  EXPECT_EQ(figures.compared, 3u);  // the equal infinities, and two pairs of numbers
  EXPECT_EQ(figures.mse, 0.25 / 3.0);
  EXPECT_EQ(figures.over, 5u);  // all but the two NaNs, the equal infinities and the zeros
}

TEST(Figures, OfNoNumbersThereIsNoMean) {
  const Figures figures = of({kNan}, {kNan});
  EXPECT_EQ(figures.compared, 0u);
  EXPECT_TRUE(std::isnan(figures.mse));
  EXPECT_TRUE(std::isnan(figures.psnr));
  EXPECT_EQ(figures.over, 0u);
}

TEST(Figures, BackgroundDepthIsAValueLikeAnyOther) {
  const Figures figures = of({1e30F}, {2.0F});
  const double error = double(1e30F) - 2.0;
  EXPECT_EQ(figures.mse, error * error);
  EXPECT_TRUE(std::isfinite(figures.relative_mse));
}

RC_GTEST_PROP(Figures, ScalingBothScalesTheErrors, ()) {
  const auto values = rc::gen::container<std::vector<int>>(6, rc::gen::inRange(-1000, 1000));
  const std::vector<int> p = *values, q = *values;
  std::vector<float> a(p.begin(), p.end()), b(q.begin(), q.end());
  const Figures once = of(a, b);
  for (float& v : a)
    v *= 4.0F;
  for (float& v : b)
    v *= 4.0F;
  const Figures scaled = of(a, b);
  RC_ASSERT(scaled.mse == 16.0 * once.mse);  // powers of two: exact
  RC_ASSERT(scaled.mae == 4.0 * once.mae);
  RC_ASSERT(scaled.largest.error == 4.0 * once.largest.error);
  RC_ASSERT(scaled.largest.place == once.largest.place);
  RC_ASSERT(of(b, a).mse == scaled.mse);
}

}  // namespace
}  // namespace alhazen
