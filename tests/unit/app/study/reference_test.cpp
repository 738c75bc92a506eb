#include "app/study/reference.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "app/study/truncation_ladder.h"

namespace alhazen {
namespace {

RgbPicture picture_of(int side, double value) {
  RgbPicture picture{side, side, {}};
  picture.rgb.assign(3 * static_cast<std::size_t>(side * side), value);
  return picture;
}

TEST(PictureErrors, AreThoseOfTheFormulas) {
  RgbPicture a = picture_of(2, 0.5);
  const RgbPicture b = picture_of(2, 0.5);
  a.rgb[0] += 0.06;
  a.rgb[4] -= 0.003;
  const PictureErrors errors = errors_of(a, b, {});
  EXPECT_NEAR(errors.rmse, std::sqrt((0.06 * 0.06 + 0.003 * 0.003) / 12), 1e-15);
  EXPECT_NEAR(errors.relative_mse, (0.06 * 0.06 + 0.003 * 0.003) / 12 / 0.26, 1e-15);
  EXPECT_NEAR(errors.largest, 0.06, 1e-15);
  EXPECT_EQ(errors.pixels_over, 1u);  // 0.003 is less than 1/255
  EXPECT_EQ(errors.pixels, 4u);
  EXPECT_EQ(errors.share_over(), 0.25);
  EXPECT_GT(errors.flip, 0);
  EXPECT_NEAR(rmse_of(a, b), errors.rmse, 1e-15);
}

TEST(PictureErrors, RoundingOfDoublesIsSeen) {
  RgbPicture a = picture_of(1, 1);
  a.rgb[0] = std::nextafter(1.0, 2.0);
  EXPECT_NEAR(errors_of(a, picture_of(1, 1), {}).rmse, 0x1p-52 / std::sqrt(3), 1e-25);
}

TEST(PictureErrors, NotANumberIsCountedAndInNoMean) {
  RgbPicture a = picture_of(2, 0.5);
  a.rgb[3] = std::nan("");
  const PictureErrors errors = errors_of(a, picture_of(2, 0.5), {});
  EXPECT_EQ(errors.not_finite, 1u);
  EXPECT_EQ(errors.pixels_over, 1u);
  EXPECT_EQ(errors.rmse, 0);
}

// Halves with noise of a known spread: the mean's error is known, and can be measured.
TEST(Reference, EstimatesItsOwnError) {
  constexpr int kSide = 100;
  constexpr double kSigma = 0.01;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, kSigma);
  const RgbPicture truth = picture_of(kSide, 0.5);
  RgbPicture halves[2] = {truth, truth};
  for (RgbPicture& half : halves) {
    for (double& value : half.rgb)
      value += noise(random);
  }
  const double estimate = error_of_mean(halves[0], halves[1]);
  const double expected = kSigma / std::sqrt(2);
  // 30000 values: the estimate's own standard error is 1 / sqrt(60000) of it; six of those.
  EXPECT_NEAR(estimate, expected, 6 * expected / std::sqrt(60000));
  EXPECT_NEAR(rmse_of(mean_of(halves[0], halves[1]), truth), expected,
              6 * expected / std::sqrt(60000));
}

TEST(Reference, FloorIsTenTimesBothErrorsTogether) {
  Reference reference;
  reference.sampling_error = 3e-4;
  reference.truncation_error = 4e-4;
  EXPECT_DOUBLE_EQ(reference.floor(), 5e-3);
}

TEST(Reference, SeedsOfTheHalvesDiffer) {
  for (const std::uint64_t seed : {0u, 1u, 77u}) {
    EXPECT_NE(half_seed(seed, 0), half_seed(seed, 1));
    EXPECT_NE(half_seed(seed, 0), seed);
    EXPECT_LE(half_seed(seed, 0), static_cast<std::uint64_t>(kMaxSeed));
  }
}

// What is left out falls with the depth as a power: a room of mirrors.
Result<RungPicture> room_of_mirrors(const TruncationRung& rung) {
  return RungPicture{picture_of(1, 1 - std::pow(0.5, rung.max_depth)), 1e-3};
}

TEST(TruncationLadder, ClimbsUntilTheLastStepIsSmall) {
  const auto found = climb({4, 1e-3}, {1e-4, 1}, room_of_mirrors);
  ASSERT_TRUE(found);
  EXPECT_EQ(found.value().rung.max_depth, 32);  // 8 changes 0.06, 16 0.004, 32 1.5e-5
  EXPECT_NEAR(found.value().error, 0x1p-16, 1e-9);
  // What it is off by is less than the step that was taken for it.
  EXPECT_LT(std::pow(0.5, 32), found.value().error);
  EXPECT_DOUBLE_EQ(found.value().rung.cutoff, 1e-3 / 512);
}

TEST(TruncationLadder, StopsWhenTheNextRungIsTooDear) {
  const auto dear = [](const TruncationRung& rung) -> Result<RungPicture> {
    return RungPicture{picture_of(1, 1 - std::pow(0.99, rung.max_depth)), 1.0 * rung.max_depth};
  };
  const auto found = climb({4, 1e-3}, {1e-9, 40}, dear);
  ASSERT_TRUE(found);
  EXPECT_EQ(found.value().rung.max_depth, 32);  // 64 would take 64 seconds
  EXPECT_GT(found.value().error, 0.1);
}

TEST(TruncationLadder, ErrorsOfTheRendererComeThrough) {
  const auto fails = [](const TruncationRung&) -> Result<RungPicture> {
    return Error{ErrorCode::stopped, "stopped"};
  };
  EXPECT_EQ(climb({4, 1e-3}, {}, fails).error().code, ErrorCode::stopped);
}

}  // namespace
}  // namespace alhazen
