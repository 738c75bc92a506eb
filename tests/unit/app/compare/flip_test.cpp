#include "app/compare/flip.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "app/compare/flip_color.h"

namespace alhazen {
namespace {

render::FloatBuffer constant(int width, int height, Rgbd color) {
  render::FloatBuffer picture(width, height, {"R", "G", "B"});
  std::ranges::fill(picture.channel(0), static_cast<float>(color.r));
  std::ranges::fill(picture.channel(1), static_cast<float>(color.g));
  std::ranges::fill(picture.channel(2), static_cast<float>(color.b));
  return picture;
}

render::FloatBuffer noise(int width, int height, unsigned seed) {
  render::FloatBuffer picture(width, height, {"R", "G", "B"});
  std::mt19937 random(seed);
  for (std::size_t c = 0; c < 3; ++c) {
    for (float& sample : picture.channel(c))
      sample = static_cast<float>(random() % 257) / 256.0F;
  }
  return picture;
}

// The remapped error of two constant pictures, by the paper's formulas alone: no filter changes a
// constant, and nothing in it is an edge.
double of_constants(Rgbd a, Rgbd b) {
  const auto adjusted = [](Rgbd light) {
    const Rgbd lab = lab_of_xyz(xyz_of_light(light));
    return Rgbd(lab.r, 0.01 * lab.r * lab.g, 0.01 * lab.r * lab.b);
  };
  const double largest = std::pow(hyab(adjusted({0, 1, 0}), adjusted({0, 0, 1})), 0.7);
  const double difference = std::pow(hyab(adjusted(a), adjusted(b)), 0.7);
  const double bend = 0.4 * largest;
  return difference < bend ? 0.95 * difference / bend
                           : 0.95 + 0.05 * (difference - bend) / (largest - bend);
}

// The derivatives of a constant are sums of weights that cancel to a few roundings of 16, the
// constant term of Y_y; FLIP takes their square root: sqrt(2^-53 * 16 * 40) is below 1e-6.
constexpr double kFeatureRounding = 1e-6;
// Pictures are floats: Y_y up to 100 and C_x, C_z up to 60 are right to 2^-24 of that, which the
// exponent 0.7 of a small difference makes larger; colours here are far apart.
constexpr double kColorRounding = 1e-5;

TEST(Flip, EqualPicturesDoNotDiffer) {
  const render::FloatBuffer picture = noise(37, 23, 1);
  const FlipResult result = flip(picture, picture);
  EXPECT_EQ(result.mean, 0.0);
  EXPECT_EQ(result.largest.error, 0.0);
}

TEST(Flip, BlackAndWhiteAre100OfLightnessApart) {
  // HyAB is 100, to the power of 0.7 25.119; green to blue is about 41.3.
  const double expected = of_constants({0, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(expected, 0.967, 0.0005);
  const FlipResult result = flip(constant(40, 30, {0, 0, 0}), constant(40, 30, {1, 1, 1}));
  EXPECT_NEAR(result.mean, expected, kFeatureRounding);
  EXPECT_NEAR(result.largest.error, expected, kFeatureRounding);
}

TEST(Flip, GreenAndBlueAreTheLargestDifference) {
  const FlipResult result = flip(constant(20, 20, {0, 1, 0}), constant(20, 20, {0, 0, 1}));
  EXPECT_NEAR(result.mean, 1.0, kColorRounding);
}

TEST(Flip, OfConstantsIsTheFormula) {
  const Rgbd colors[] = {{0.5, 0.5, 0.5}, {0.9, 0.1, 0.1}, {0.2, 0.7, 0.3}, {0.05, 0.1, 0.6}};
  for (const Rgbd a : colors) {
    for (const Rgbd b : colors) {
      if (a == b) continue;
      const FlipResult result = flip(constant(25, 9, a), constant(25, 9, b));
      EXPECT_NEAR(result.mean, of_constants(a, b), kColorRounding);
    }
  }
}

TEST(Flip, IsSymmetricAndWithinItsScale) {
  const render::FloatBuffer a = noise(41, 29, 2), b = noise(41, 29, 3);
  const FlipResult there = flip(a, b), back = flip(b, a);
  EXPECT_EQ(there.errors, back.errors);
  EXPECT_GT(there.mean, 0.0);
  for (const float error : there.errors.channel(0)) {
    EXPECT_GE(error, 0.0F);
    EXPECT_LE(error, 1.0F);
  }
}

TEST(Flip, MovesWithThePictures) {
  // The same pictures, once 7 to the right and 5 down, on a field of black that no filter crosses:
  // the widest reaches 10 pixels.
  const render::FloatBuffer spot = noise(6, 6, 4), other = noise(6, 6, 5);
  const auto placed = [](const render::FloatBuffer& what, int x, int y) {
    render::FloatBuffer field = constant(60, 60, {0, 0, 0});
    for (std::size_t c = 0; c < 3; ++c) {
      for (int i = 0; i < 36; ++i)
        field.at(c, x + i % 6, y + i / 6) = what.at(c, i % 6, i / 6);
    }
    return field;
  };
  const FlipResult here = flip(placed(spot, 20, 20), placed(other, 20, 20));
  const FlipResult moved = flip(placed(spot, 27, 25), placed(other, 27, 25));
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x)
      ASSERT_EQ(here.errors.at(0, x, y), moved.errors.at(0, x + 7, y + 5)) << x << " " << y;
  }
}

TEST(Flip, MirroredPicturesDifferAsMuch) {
  const render::FloatBuffer a = noise(31, 17, 6), b = noise(31, 17, 7);
  const auto mirrored = [](const render::FloatBuffer& picture) {
    render::FloatBuffer result = picture;
    for (std::size_t c = 0; c < 3; ++c) {
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
          result.at(c, x, y) = picture.at(c, picture.width() - 1 - x, y);
      }
    }
    return result;
  };
  // Sums in another order: equal to double's rounding, far below that of the float they end in.
  EXPECT_NEAR(flip(a, b).mean, flip(mirrored(a), mirrored(b)).mean, 1e-12);
}

TEST(Flip, SmallErrorsAreSeenBetterFromClose) {
  // A checkerboard of pixels against its mean: from afar the eye blurs it away.
  render::FloatBuffer checks = constant(40, 40, {0, 0, 0});
  for (std::size_t c = 0; c < 3; ++c) {
    for (int i = 0; i < 1600; ++i)
      checks.at(c, i % 40, i / 40) = static_cast<float>((i % 40 + i / 40) % 2);
  }
  const render::FloatBuffer gray = constant(40, 40, {0.5, 0.5, 0.5});
  EXPECT_LT(flip(checks, gray, 67.0).mean, 0.5 * flip(checks, gray, 10.0).mean);
}

TEST(Flip, ExponentsAreThoseOfThePaper) {
  // A step of the whole range gives an edge of 1: (1 / sqrt 2)^0.5.
  EXPECT_DOUBLE_EQ(flip_feature_error(1.0, 0.0), std::pow(2.0, -0.25));
  EXPECT_DOUBLE_EQ(flip_feature_error(0.0, -0.02), std::sqrt(0.02 / std::numbers::sqrt2));
  EXPECT_EQ(flip_feature_error(0.0, 0.0), 0.0);
  EXPECT_EQ(flip_error(0.25, 0.5), 0.5);
  EXPECT_EQ(flip_error(0.25, 0.0), 0.25);
  EXPECT_EQ(flip_error(0.25, 1.0), 1.0);
  // At the bend both halves of the scale give p_t: 0.4 of the largest, in lightness alone.
  const double bend =
      std::pow(0.4, 1.0 / 0.7) * hyab(hunt_adjusted(lab_of_xyz(xyz_of_light({0, 1, 0}))),
                                      hunt_adjusted(lab_of_xyz(xyz_of_light({0, 0, 1}))));
  EXPECT_NEAR(flip_color_error({bend, 0, 0}, {0, 0, 0}), 0.95, 1e-12);
  EXPECT_NEAR(flip_color_error({0.999999 * bend, 0, 0}, {0, 0, 0}), 0.95, 1e-6);
}

}  // namespace
}  // namespace alhazen
