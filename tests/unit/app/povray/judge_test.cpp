#include "app/povray/judge.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace alhazen {
namespace {

constexpr int kSide = 40;  // 4800 channels: 0.1 % of them are 4.8
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

struct Pair {
  render::FloatBuffer ours{kSide, kSide, {"R", "G", "B"}};
  render::FloatBuffer theirs{kSide, kSide, {"R", "G", "B"}};
  std::vector<std::uint32_t> objects = std::vector<std::uint32_t>(kSide * kSide, 7);

  // Both all of one grey.
  explicit Pair(float gray) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::ranges::fill(ours.channel(c), gray);
      std::ranges::fill(theirs.channel(c), gray);
    }
  }
  static void set(render::FloatBuffer& picture, int x, int y, float gray) {
    for (std::size_t c = 0; c < 3; ++c)
      picture.at(c, x, y) = gray;
  }
  Verdict verdict(const Allowance* allowance = nullptr) const {
    return judge(ours, theirs, objects, allowance);
  }
};

TEST(Judge, TheSamePictureIsTheSame) {
  const Verdict verdict = Pair(0.5F).verdict();
  EXPECT_TRUE(verdict.passes);
  EXPECT_EQ(verdict.channels, 3U * kSide * kSide);
  EXPECT_EQ(verdict.over, 0U);
  EXPECT_EQ(verdict.rmse, 0);
  EXPECT_TRUE(verdict.pixels.empty());
}

// max(2e-5, 2^-10 |theirs|), and that much itself is within it.
TEST(Judge, TheToleranceEndsAtItsBound) {
  Pair pair(0.5F);
  const float bound = 0.5F + 0x1p-11F;
  Pair::set(pair.ours, 3, 3, bound);
  EXPECT_EQ(pair.verdict().over, 0U);
  Pair::set(pair.ours, 3, 3, std::nextafter(bound, 1.0F));
  EXPECT_EQ(pair.verdict().over, 3U);
  Pair dark(0);
  Pair::set(dark.ours, 3, 3, std::nextafter(2e-5F, 0.0F));
  EXPECT_EQ(dark.verdict().over, 0U);
  Pair::set(dark.ours, 3, 3, std::nextafter(2e-5F, 1.0F));
  EXPECT_EQ(dark.verdict().over, 3U);
}

// POV-Ray's picture is the reference: its larger value widens the tolerance, ours does not.
TEST(Judge, TheToleranceIsRelativeToPovRay) {
  Pair pair(1);
  const float wide = 1 + 0x1p-10F;
  Pair::set(pair.theirs, 0, 0, wide);
  EXPECT_TRUE(pair.verdict().passes);
  Pair::set(pair.theirs, 0, 0, 1 - 0x1p-10F);
  EXPECT_EQ(pair.verdict().over, 3U);
}

TEST(Judge, AnOffsetIsUnexplained) {
  Pair pair(0.5F);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      Pair::set(pair.theirs, x, y, 0.501F);
  }
  const Verdict verdict = pair.verdict();
  EXPECT_FALSE(verdict.passes);
  EXPECT_EQ(verdict.over, verdict.channels);
  EXPECT_EQ(verdict.pixels.size(), std::size_t{kSide * kSide});
  for (const JudgedPixel& pixel : verdict.pixels)
    EXPECT_EQ(pixel.cause, Cause::unexplained);
  EXPECT_NEAR(verdict.rmse, 0.001, 1e-7);  // the difference of two floats near 0.5
}

TEST(Judge, OnePixelOffInAFlatPlaceIsEnoughToFail) {
  Pair pair(0.5F);
  pair.ours.at(1, 20, 20) = 0.51F;
  const Verdict verdict = pair.verdict();
  EXPECT_FALSE(verdict.passes);
  ASSERT_EQ(verdict.pixels.size(), 1U);
  EXPECT_EQ(verdict.pixels[0].place, (PixelPlace{20, 20}));
  EXPECT_EQ(verdict.pixels[0].cause, Cause::unexplained);
  EXPECT_EQ(verdict.pixels[0].ours.g, 0.51F);
  EXPECT_EQ(verdict.pixels[0].theirs.g, 0.5F);
}

// Left of `edge` 0.2, from there on 0.8.
void step(render::FloatBuffer& picture, int row, int edge) {
  for (int x = 0; x < kSide; ++x)
    Pair::set(picture, x, row, x < edge ? 0.2F : 0.8F);
}

TEST(Judge, AStepThatMovedByAPixelIsAnEdge) {
  Pair pair(0.2F);
  for (int y = 0; y < kSide; ++y) {
    step(pair.ours, y, 20);
    step(pair.theirs, y, y == 5 ? 21 : 20);
  }
  const Verdict verdict = pair.verdict();
  EXPECT_TRUE(verdict.passes) << verdict.sentence;
  ASSERT_EQ(verdict.pixels.size(), 1U);
  EXPECT_EQ(verdict.pixels[0].place, (PixelPlace{20, 5}));
  EXPECT_EQ(verdict.pixels[0].cause, Cause::edge);
}

// The step beside it is one of 0.6, and does not explain a speck that is off by more.
TEST(Judge, ADifferenceLargerThanTheStepIsNoEdge) {
  Pair pair(0.2F);
  for (int y = 0; y < kSide; ++y) {
    step(pair.ours, y, 20);
    step(pair.theirs, y, 20);
  }
  pair.theirs.at(2, 20, 5) = 4.0F;
  const Verdict verdict = pair.verdict();
  EXPECT_FALSE(verdict.passes);
  ASSERT_EQ(verdict.pixels.size(), 1U);
  EXPECT_EQ(verdict.pixels[0].cause, Cause::unexplained);
}

// 5 of 4800 channels are more than 0.1 %, 4 are less; all of them are edges.
TEST(Judge, TooManyEdgesFail) {
  for (const int channels : {4, 5}) {
    Pair pair(0.2F);
    for (int y = 0; y < kSide; ++y) {
      step(pair.ours, y, 20);
      step(pair.theirs, y, 20);
    }
    for (int i = 0; i < channels; ++i)
      pair.theirs.at(0, 20, 3 * i + 1) = 0.2F;
    const Verdict verdict = pair.verdict();
    ASSERT_EQ(verdict.over, static_cast<std::uint64_t>(channels));
    for (const JudgedPixel& pixel : verdict.pixels)
      EXPECT_EQ(pixel.cause, Cause::edge);
    EXPECT_EQ(verdict.passes, channels == 4) << verdict.sentence;
  }
}

TEST(Judge, AnotherObjectBesideItIsASilhouette) {
  Pair pair(0.5F);
  Pair::set(pair.ours, 0, 0, 0.9F);
  pair.objects[kSide + 1] = 8;  // at (1, 1), a neighbour by its corner
  Verdict verdict = pair.verdict();
  EXPECT_TRUE(verdict.passes);
  ASSERT_EQ(verdict.pixels.size(), 1U);
  EXPECT_EQ(verdict.pixels[0].cause, Cause::silhouette);
  pair.objects[kSide + 1] = 7;
  pair.objects[2] = 8;  // two columns away
  verdict = pair.verdict();
  EXPECT_FALSE(verdict.passes);
  EXPECT_EQ(verdict.pixels[0].cause, Cause::unexplained);
}

TEST(Judge, AnAllowanceBoundsTheRmse) {
  Pair pair(0.5F);
  Pair::set(pair.ours, 20, 20, 0.75F);
  const double rmse = 0.25 / kSide;  // one pixel of kSide^2
  Allowance allowance{rmse, "because"};
  const Verdict passing = pair.verdict(&allowance);
  EXPECT_TRUE(passing.passes);
  EXPECT_NE(passing.sentence.find("because"), std::string::npos);
  allowance.rmse = std::nextafter(rmse, 0.0);
  EXPECT_FALSE(pair.verdict(&allowance).passes);
}

// Whatever is beside it, and whatever the scene is allowed: no number is never right.
TEST(Judge, WhatIsNotFiniteFails) {
  const float pairs[][2] = {{kNan, 0.5F},      {0.5F, kNan},      {kNan, kNan},
                            {kInfinite, 0.5F}, {0.5F, kInfinite}, {kInfinite, kInfinite},
                            {-kInfinite, kNan}};
  const Allowance generous{1e30, "anything goes"};
  for (const auto& [ours, theirs] : pairs) {
    Pair pair(0.5F);
    Pair::set(pair.ours, 20, 20, ours);
    Pair::set(pair.theirs, 20, 20, theirs);
    pair.objects[20 * kSide + 21] = 8;
    for (const Allowance* allowance : {static_cast<const Allowance*>(nullptr), &generous}) {
      const Verdict verdict = pair.verdict(allowance);
      EXPECT_FALSE(verdict.passes) << ours << ' ' << theirs;
      EXPECT_EQ(verdict.not_finite, 3U);
      EXPECT_NE(verdict.sentence.find("not finite"), std::string::npos);
      for (const JudgedPixel& pixel : verdict.pixels)
        EXPECT_EQ(pixel.cause, Cause::unexplained);
    }
  }
}

TEST(Judge, APictureOfOnePixelHasNoNeighbours) {
  render::FloatBuffer one(1, 1, {"R", "G", "B"}), other = one;
  other.at(0, 0, 0) = 1;
  EXPECT_TRUE(judge(one, one, {0}, nullptr).passes);
  EXPECT_FALSE(judge(one, other, {0}, nullptr).passes);
}

}  // namespace
}  // namespace alhazen
