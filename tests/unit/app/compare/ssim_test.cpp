#include "app/compare/ssim.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "app/compare/row_filter.h"

namespace alhazen {
namespace {

render::FloatBuffer constant(float code) {
  render::FloatBuffer picture(20, 15, {"Y"});
  std::ranges::fill(picture.channel(0), code);
  return picture;
}

render::FloatBuffer noise(unsigned seed) {
  render::FloatBuffer picture(24, 19, {"Y"});
  std::mt19937 random(seed);
  for (float& sample : picture.channel(0))
    sample = static_cast<float>(random() % 129) / 256.0F;  // 0 .. 1/2, exact
  return picture;
}

// Variances are differences of means of squares up to 1: right to a few 2^-53 against C2 = 9e-4.
constexpr double kRounding = 1e-12;

TEST(Ssim, OfEqualPicturesIsOne) {
  EXPECT_EQ(mean_ssim(noise(1), noise(1)), 1.0);
  EXPECT_EQ(mean_ssim(constant(0.3F), constant(0.3F)), 1.0);
}

TEST(Ssim, OfConstantsIsTheLuminanceTerm) {
  for (const float a : {0.0F, 0.25F, 1.0F}) {
    for (const float b : {0.125F, 0.5F, 1.0F}) {
      const double p = a, q = b;
      const double expected = (2 * p * q + 0.0001) / (p * p + q * q + 0.0001);
      EXPECT_NEAR(mean_ssim(constant(a), constant(b)).value(), expected, kRounding);
    }
  }
}

TEST(Ssim, OfAPictureAndItsNegativeAboutTheMeanIsNegative) {
  // Stripes of one pixel, c +- d: in every window the means are within d of c, and the covariance
  // is minus the variance.
  render::FloatBuffer stripes(40, 40, {"Y"}), negative(40, 40, {"Y"});
  for (int i = 0; i < 1600; ++i) {
    const float swing = i % 2 == 0 ? 0.25F : -0.25F;
    stripes.at(0, i % 40, i / 40) = 0.5F + swing;
    negative.at(0, i % 40, i / 40) = 0.5F - swing;
  }
  // The Gaussian's mean of the alternating swing is m = +-0.25 s, s = sum of w_k (-1)^k, whose
  // square is the same in all windows; the means are 0.5 +- m, the variances 1/16 - m^2.
  const Kernel kernel = gaussian_kernel(1.5, 5);
  double s = 0.0;
  for (std::size_t k = 0; k < kernel.size(); ++k)
    s += k % 2 == 0 ? kernel[k] : -kernel[k];
  const double m = 0.25 * s, variance = 0.0625 - m * m;
  const double means = (2 * (0.25 - m * m) + 0.0001) / (2 * (0.25 + m * m) + 0.0001);
  const double structure = (-2 * variance + 0.0009) / (2 * variance + 0.0009);
  EXPECT_NEAR(mean_ssim(stripes, negative).value(), means * structure, kRounding);
  EXPECT_LT(means * structure, -0.9);
}

TEST(Ssim, AnOffsetLeavesTheStructureAlone) {
  // With x + c every variance and covariance is that of x: the index is the luminance term of each
  // window, at most that of the darkest and least that of the brightest mean, both in 0 .. 1/2.
  const render::FloatBuffer picture = noise(2);
  render::FloatBuffer brighter = picture;
  for (float& sample : brighter.channel(0))
    sample += 0.25F;
  const auto term = [](double p, double q) {
    return (2 * p * q + 0.0001) / (p * p + q * q + 0.0001);
  };
  const double value = mean_ssim(picture, brighter).value();
  EXPECT_GT(value, term(0.0, 0.25));
  EXPECT_LT(value, term(0.5, 0.75));
  // The window's mean is near 1/4 everywhere: the mean of 60 or so independent samples.
  EXPECT_NEAR(value, term(0.25, 0.5), 0.05);
}

TEST(Ssim, IsSymmetric) {
  EXPECT_EQ(mean_ssim(noise(3), noise(4)), mean_ssim(noise(4), noise(3)));
  EXPECT_LT(mean_ssim(noise(3), noise(4)).value(), 0.5);
}

TEST(Ssim, NeedsAWindow) {
  const render::FloatBuffer narrow(10, 50, {"Y"}), low(50, 10, {"Y"}), one(11, 11, {"Y"});
  EXPECT_EQ(mean_ssim(narrow, narrow), std::nullopt);
  EXPECT_EQ(mean_ssim(low, low), std::nullopt);
  EXPECT_EQ(mean_ssim(one, one), 1.0);
}

TEST(Ssim, LumaOfGrayIsItsCode) {
  render::FloatBuffer light(2, 1, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c)
    light.at(c, 1, 0) = 0.21404114F;  // IEC 61966-2-1: the light of code 0.5
  const render::FloatBuffer codes = luma(light);
  EXPECT_EQ(codes.at(0, 0, 0), 0.0F);
  EXPECT_NEAR(codes.at(0, 1, 0), 0.5, 1e-7);
}

}  // namespace
}  // namespace alhazen
