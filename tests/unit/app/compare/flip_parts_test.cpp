// tests/unit/app/compare: the colour spaces and filters that FLIP is made of.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

#include "app/compare/flip.h"
#include "app/compare/flip_color.h"
#include "app/compare/flip_view.h"
#include "core/math/chromaticities.h"

namespace alhazen {
namespace {

// A handful of roundings of numbers up to 500.
constexpr double kRounding = 1e-12;

void expect_near(Rgbd a, Rgbd b, double bound) {
  EXPECT_NEAR(a.r, b.r, bound);
  EXPECT_NEAR(a.g, b.g, bound);
  EXPECT_NEAR(a.b, b.b, bound);
}

double sum(const Kernel& kernel) {
  return std::accumulate(kernel.begin(), kernel.end(), 0.0);
}

// CIE 1931 chromaticity of a light, from XYZ that is relative to D65.
Xy chromaticity(Rgbd light) {
  const Rgbd xyz = xyz_of_light(light);
  const Xy white = kRec709.white;
  const double x = xyz.r * white.x / white.y, y = xyz.g;
  const double z = xyz.b * (1.0 - white.x - white.y) / white.y;
  return {x / (x + y + z), y / (x + y + z)};
}

TEST(FlipColor, PrimariesAndWhiteAreThoseOfRec709) {
  const auto expect_xy = [](Xy found, Xy expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-14);
    EXPECT_NEAR(found.y, expected.y, 1e-14);
  };
  expect_xy(chromaticity({1, 0, 0}), kRec709.red);
  expect_xy(chromaticity({0, 1, 0}), kRec709.green);
  expect_xy(chromaticity({0, 0, 1}), kRec709.blue);
  expect_near(xyz_of_light({1, 1, 1}), {1, 1, 1}, 1e-15);
}

TEST(FlipColor, SpacesLeadBack) {
  for (const Rgbd light : {Rgbd{0.1, 0.5, 0.9}, Rgbd{1, 0, 0}, Rgbd{0, 0, 0}, Rgbd{1, 1, 1}}) {
    const Rgbd xyz = xyz_of_light(light);
    expect_near(light_of_xyz(xyz), light, 1e-14);
    expect_near(xyz_of_ycxcz(ycxcz_of_xyz(xyz)), xyz, 1e-14);
  }
}

TEST(FlipColor, LightnessIsThatOfCie) {
  expect_near(lab_of_xyz({0, 0, 0}), {0, 0, 0}, kRounding);
  expect_near(lab_of_xyz({1, 1, 1}), {100, 0, 0}, kRounding);
  // (1/2)^3 of the luminance is half way: 116 / 2 - 16. Below (6/29)^3 it is (29/3)^3 Y.
  expect_near(lab_of_xyz({0.125, 0.125, 0.125}), {42, 0, 0}, kRounding);
  expect_near(lab_of_xyz({0.001, 0.001, 0.001}), {0.001 * 24389.0 / 27.0, 0, 0}, kRounding);
}

TEST(FlipColor, HuntAndHyab) {
  EXPECT_EQ(hunt_adjusted({50, 20, -40}), Rgbd(50, 10, -20));
  EXPECT_EQ(hyab({50, 3, 4}, {40, 0, 0}), 15.0);  // 10 of lightness and 5 of colour
}

TEST(FlipKernels, LeaveConstantsAsTheyAre) {
  for (const double pixels_per_degree : {1.0, 20.0, kFlipPixelsPerDegree, 300.0}) {
    for (const GaussianSum& terms : sensitivity_kernels(pixels_per_degree).channels) {
      double total = 0.0;
      for (const GaussianTerm& term : terms)
        total += term.weight * sum(term.kernel) * sum(term.kernel);
      EXPECT_NEAR(total, 1.0, 1e-13);
    }
    const FeatureKernels features = feature_kernels(pixels_per_degree);
    EXPECT_NEAR(sum(features.smooth), 1.0, 1e-13);
    EXPECT_NEAR(sum(features.first), 0.0, 1e-13);
    EXPECT_NEAR(sum(features.second), 0.0, 1e-13);
  }
}

TEST(FlipKernels, FallAsThePaperSays) {
  // Ratios of weights do not depend on how the filters are scaled.
  const double degrees = 3.0 / kFlipPixelsPerDegree;
  const double d2 = std::numbers::pi * std::numbers::pi * degrees * degrees;
  const SensitivityKernels kernels = sensitivity_kernels(kFlipPixelsPerDegree);
  EXPECT_EQ(kernels.radius, 10);  // 3 sigma: ceil(3 * sqrt(0.04 / (2 pi^2)) * 67.02)
  const auto weight = [&](std::size_t channel, int x) {
    double total = 0.0;
    for (const auto& [w, kernel] : kernels.channels[channel]) {
      total += w * kernel[static_cast<std::size_t>(10 + x)] * kernel[10];
    }
    return total;
  };
  EXPECT_NEAR(weight(0, 3) / weight(0, 0), std::exp(-d2 / 0.0047), 1e-13);
  EXPECT_NEAR(weight(1, 3) / weight(1, 0), std::exp(-d2 / 0.0053), 1e-13);
  const double wide = 34.1 * std::sqrt(std::numbers::pi / 0.04);
  const double narrow = 13.5 * std::sqrt(std::numbers::pi / 0.025);
  EXPECT_NEAR(weight(2, 3) / weight(2, 0),
              (wide * std::exp(-d2 / 0.04) + narrow * std::exp(-d2 / 0.025)) / (wide + narrow),
              1e-13);
}

TEST(FlipKernels, DerivativesAreOddAndEven) {
  const FeatureKernels kernels = feature_kernels(kFlipPixelsPerDegree);
  EXPECT_EQ(kernels.radius, 9);  // ceil(3 * 0.5 * 0.082 * 67.02)
  ASSERT_EQ(kernels.first.size(), 19u);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_DOUBLE_EQ(kernels.first[i], -kernels.first[18 - i]);
    EXPECT_DOUBLE_EQ(kernels.second[i], kernels.second[18 - i]);
  }
  const double inner = kernels.second[9];
  EXPECT_LT(inner, 0.0);
  // The second derivative changes its sign at sigma: 2.75 pixels.
  EXPECT_LT(kernels.second[9 + 2], 0.0);
  EXPECT_GT(kernels.second[9 + 3], 0.0);
}

// Black to the left of column 30, white from there on.
render::FloatBuffer step() {
  render::FloatBuffer picture(60, 5, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c) {
    for (int i = 0; i < 300; ++i)
      picture.at(c, i % 60, i / 60) = i % 60 < 30 ? 0.0F : 1.0F;
  }
  return picture;
}

TEST(FlipView, StepFromBlackToWhiteIsAnEdgeOfOne) {
  FlipView view(step(), kFlipPixelsPerDegree);
  const FlipView::Row row = view.row(2);
  // On both sides of the step one half of the first derivative sees white, all of its weights of
  // one sign; floats hold -16 and 100 exactly.
  EXPECT_NEAR(row.edges[29], 1.0, kRounding);
  EXPECT_NEAR(row.edges[30], 1.0, kRounding);
  EXPECT_NEAR(row.edges[28], row.edges[31], kRounding);
  EXPECT_LT(row.edges[28], 1.0);
  EXPECT_NEAR(row.edges[20], 0.0, kRounding);  // 10 pixels off: out of reach
  // Half of the second derivative: what is left is half of its middle weight.
  const double middle = feature_kernels(kFlipPixelsPerDegree).second[9];
  EXPECT_NEAR(row.points[30], -0.5 * middle, kRounding);
}

TEST(FlipView, ColoursFarFromAnEdgeAreTheirOwn) {
  FlipView view(step(), kFlipPixelsPerDegree);
  const FlipView::Row row = view.row(0);
  // The filter's sum is 1 to rounding, and the steep end of L* makes 903 times that of black.
  expect_near(row.colors[10], {0, 0, 0}, 1e-10);
  expect_near(row.colors[50], {100, 0, 0}, 1e-10);
}

}  // namespace
}  // namespace alhazen
