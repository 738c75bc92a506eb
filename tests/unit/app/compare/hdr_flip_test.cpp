#include "app/compare/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace alhazen {
namespace {

// Gray, so that the luminance is the value: to the rounding of 0.2126 + 0.7152 + 0.0722.
render::FloatBuffer gray(int width, int height, float value) {
  render::FloatBuffer picture(width, height, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c)
    std::ranges::fill(picture.channel(c), value);
  return picture;
}

void set(render::FloatBuffer& picture, int x, int y, float value) {
  for (std::size_t c = 0; c < 3; ++c)
    picture.at(c, x, y) = value;
}

constexpr double kRounding = 1e-12;

TEST(FlipExposures, ShowTheBrightestAndTheMedianAs85Percent) {
  render::FloatBuffer reference = gray(5, 5, 0.125F);
  set(reference, 1, 1, 8.0F);
  set(reference, 2, 1, 0.0F);
  const FlipExposures exposures = flip_exposures(reference);
  EXPECT_NEAR(film_curve(8.0 * std::exp2(exposures.first)), 0.85, kRounding);
  EXPECT_NEAR(film_curve(0.125 * std::exp2(exposures.last)), 0.85, kRounding);
  EXPECT_EQ(exposures.at(0), exposures.first);
  EXPECT_NEAR(exposures.at(exposures.count - 1), exposures.last, kRounding);
}

TEST(FlipExposures, AreAboutOneAStop) {
  render::FloatBuffer reference = gray(5, 5, 0.125F);
  EXPECT_EQ(flip_exposures(reference).count, 2);  // at least
  set(reference, 1, 1, 0.125F * 22.6F);           // 4.5 stops
  EXPECT_EQ(flip_exposures(reference).count, 5);
  set(reference, 1, 1, 1e30F);
  EXPECT_EQ(flip_exposures(reference).count, 40);  // at most
  EXPECT_EQ(flip_exposures(gray(5, 5, 0.0F)).count, 1);
}

TEST(FilmCurve, BeginsAtBlackAndEndsAtWhite) {
  EXPECT_EQ(film_curve(0.0), 0.0);
  EXPECT_EQ(film_curve(-3.0), 0.0);
  EXPECT_NEAR(film_curve(1.0), 2.54 / 3.16, kRounding);  // (2.51 + 0.03) / (2.43 + 0.59 + 0.14)
  EXPECT_EQ(film_curve(1e6), 1.0);
}

TEST(HdrFlip, EqualPicturesDoNotDiffer) {
  render::FloatBuffer picture = gray(15, 15, 0.5F);
  set(picture, 7, 7, 300.0F);
  EXPECT_EQ(hdr_flip(picture, picture).flip.largest.error, 0.0);
}

TEST(HdrFlip, SeesWhatADisplayClips) {
  // Light of 4 and of 16 is white on a display.
  render::FloatBuffer a = gray(30, 30, 0.1F), b = a;
  for (int i = 0; i < 100; ++i) {
    set(a, 10 + i % 10, 10 + i / 10, 4.0F);
    set(b, 10 + i % 10, 10 + i / 10, 16.0F);
  }
  EXPECT_GT(hdr_flip(a, b).flip.errors.at(0, 15, 15), 0.3F);
  EXPECT_EQ(hdr_flip(a, b).flip.errors.at(0, 0, 0), 0.0F);  // out of reach of what differs
}

TEST(HdrFlip, IsTheLargestOfItsExposures) {
  render::FloatBuffer a = gray(20, 20, 0.25F), b = gray(20, 20, 0.5F);
  set(a, 3, 4, 9.0F);
  set(b, 10, 4, 9.0F);
  const HdrFlipResult result = hdr_flip(a, b);
  ASSERT_GE(result.exposures.count, 2);
  render::FloatBuffer largest(20, 20, {"FLIP.E"});
  for (int i = 0; i < result.exposures.count; ++i) {
    const double exposure = result.exposures.at(i);
    const FlipResult once = flip(tone_mapped(a, exposure), tone_mapped(b, exposure));
    EXPECT_LE(once.mean, result.flip.mean);
    for (int p = 0; p < 400; ++p)
      largest.channel(0)[p] = std::max(largest.channel(0)[p], once.errors.channel(0)[p]);
  }
  EXPECT_EQ(result.flip.errors, largest);
}

TEST(HdrFlip, DoesNotDependOnTheUnitOfLight) {
  render::FloatBuffer a = gray(20, 20, 0.25F), b = gray(20, 20, 0.5F);
  set(b, 10, 4, 9.0F);
  const HdrFlipResult once = hdr_flip(a, b);
  for (render::FloatBuffer* picture : {&a, &b}) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (float& sample : picture->channel(c))
        sample *= 1024.0F;
    }
  }
  const HdrFlipResult scaled = hdr_flip(a, b);
  EXPECT_EQ(scaled.exposures.count, once.exposures.count);
  EXPECT_NEAR(scaled.exposures.first, once.exposures.first - 10.0, kRounding);
  // The exposure's last bit can move a tone mapped float by one in 2^24.
  EXPECT_NEAR(scaled.flip.mean, once.flip.mean, 1e-6);
}

}  // namespace
}  // namespace alhazen
