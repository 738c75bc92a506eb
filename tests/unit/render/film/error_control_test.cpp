#include "render/film/error_control.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "core/math/random.h"

namespace alhazen::render {
namespace {

// One sample everywhere and a second for one pixel in eight, by lot; with an eighth more if some
// differ from their neighbours.
constexpr double kFirstLook = 1 + 2.0 / 8;

// A picture whose pixels are the areas below a line, seen through samples: that of pixel p is
// shade(p) where sample_2d is below the line, 0 elsewhere.
struct Picture {
  int width = 64, height = 48;
  std::function<double(std::size_t)> area;  // of the pixel, 0 .. 1
  bool is_stratified = true;

  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  double sample(std::uint64_t seed, std::size_t p, std::uint32_t i) const {
    const std::uint64_t own = mix_64(seed, p);
    const Sample2d at = is_stratified ? sample_2d(own, i) : sample_2d(mix_64(own, i), 0);
    // A slanted line below which lies the area, as long as that is between 1/8 and 7/8.
    const double a = area(p);
    const double x = unit_real<double>(at.x), y = unit_real<double>(at.y);
    const double line = a <= 0.125 || a >= 0.875 ? a : a + 0.25 * (x - 0.5);
    return y < line ? 1 : 0;
  }
};

struct Outcome {
  double estimate, bound, rmse, share_over, samples_of_a_pixel;
  bool reached, has_seen_anything;
};

// What the renderer does: passes of samples until the control has no more.
Outcome sampled(const Picture& picture, const ErrorTarget& target, std::uint64_t seed) {
  ErrorControl control(target, picture.width, picture.height, seed);
  struct Pixel {
    double sum = 0;
    std::uint32_t taken = 0;
    double mean() const { return taken == 0 ? 0 : sum / taken; }
  };
  std::vector<Pixel> pixels(picture.size());
  double samples = 0;
  const auto take = [&](std::size_t p, std::uint32_t until) {
    for (; pixels[p].taken < until; ++samples)
      pixels[p].sum += picture.sample(seed, p, pixels[p].taken++);
  };
  while (control.has_next()) {
    for (std::size_t p = 0; p < pixels.size(); ++p) {
      const std::uint32_t wanted = control.wanted(p), taken = pixels[p].taken;
      if (wanted == taken) continue;
      const double before = pixels[p].mean();
      take(p, taken + (wanted - taken) / 2);
      const double middle = pixels[p].mean();
      take(p, wanted);
      const double after = pixels[p].mean(), outer = before - after;
      if (wanted == 1) {
        control.record_first(p, {after, after, after});
        continue;
      }
      const double inner = wanted < 4 ? 0 : 3 * middle - before - 2 * after;
      control.record(p, {{outer, outer, outer}, {inner, inner, inner}});
    }
    control.plan_next();
  }
  double squares = 0, over = 0, sum = 0;
  for (std::size_t p = 0; p < pixels.size(); ++p) {
    const double error = pixels[p].mean() - picture.area(p);
    squares += error * error;
    sum += pixels[p].sum;
    over += std::abs(error) > target.error ? 1 : 0;
  }
  const auto count = static_cast<double>(picture.size());
  return {control.estimate().value,
          control.estimate().bound,
          std::sqrt(squares / count),
          over / count,
          samples / count,
          control.reached(),
          sum > 0};
}

Picture all_in_half() {
  return {.area = [](std::size_t) { return 0.5; }};
}
// Straight lines a dozen pixels apart; between them nothing.
Picture few_edges() {
  return {.area = [](std::size_t p) { return p % 13 == 0 ? 0.2 + 0.6 * double(p % 7) / 6 : 0; }};
}
// One pixel in 30 has something small in it, and its neighbours nothing: ten pixels' area in all.
Picture specks() {
  return {.area = [](std::size_t p) { return mix_64(5, p) % 30 == 0 ? 0.1 : 0; }};
}
// Black on the left; the column in the middle is covered by `middle`.
Picture half_and_half(double middle) {
  return {.area = [middle](std::size_t p) {
    const std::size_t x = p % 64;
    return x < 32 ? 0 : x == 32 ? middle : 1;
  }};
}

// One sample of each pixel, and a second of one in eight.
TEST(ErrorControl, APictureWithoutNoiseIsKnownFromFewSamples) {
  for (const double error : {1.0 / 64, 1.0 / 255, 1.0 / 1024}) {
    const Outcome outcome = sampled({.area = [](std::size_t) { return 1.0; }}, {error, 0}, 1);
    EXPECT_TRUE(outcome.reached);
    EXPECT_EQ(outcome.estimate, 0);
    EXPECT_EQ(outcome.bound, 0);
    EXPECT_LE(outcome.samples_of_a_pixel, kFirstLook);
  }
}

// An edge between pixels makes them differ and is no noise: both columns beside it are looked at.
TEST(ErrorControl, EdgesBetweenPixelsAreNoNoise) {
  const Outcome outcome = sampled(half_and_half(1), {1.0 / 1024, 0}, 1);
  EXPECT_TRUE(outcome.reached);
  EXPECT_EQ(outcome.bound, 0);
  EXPECT_LE(outcome.samples_of_a_pixel, kFirstLook);
}

// The whole error is in 48 of 3072 pixels. Its samples are V = 1/4 at most, so that n of each pixel
// there are enough for 48 / 3072 / 4 / n = E^2: 254 at 1/255, which are 4 a pixel of the picture.
TEST(ErrorControl, AnEdgeTakesTheSamples) {
  const Outcome outcome = sampled(half_and_half(0.5), {1.0 / 255, 0}, 1);
  EXPECT_TRUE(outcome.reached);
  EXPECT_LE(outcome.rmse, 1.0 / 255);
  EXPECT_LE(outcome.samples_of_a_pixel, 4);
}

// A dot of area a in one pixel is met by the first sample, or else by the second of one pixel in
// eight: with the probability 1 - (1 - a) (1 - a / 8).
TEST(ErrorControl, ADotIsFoundAsOftenAsItsAreaSays) {
  constexpr int kTimes = 400;
  for (const double a : {0.1, 0.5}) {
    Picture picture{.area = [a](std::size_t p) { return p == 1000 ? a : 0; },
                    .is_stratified = false};
    int found = 0;
    for (std::uint64_t seed = 1; seed <= kTimes; ++seed)
      found += sampled(picture, {1.0 / 64, 0}, seed).has_seen_anything ? 1 : 0;
    const double p = 1 - (1 - a) * (1 - a / 8), expected = kTimes * p;
    EXPECT_NEAR(found, expected, 3 * std::sqrt(expected * (1 - p))) << a;
  }
}

// Of dots that the first samples met, the others are known to be there: all of the dots together
// are ten pixels, and are missed with the probability exp(-10).
TEST(ErrorControl, DotsThatWereMetTellOfThoseThatWereNot) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Outcome outcome = sampled(specks(), {1.0 / 255, 0}, seed);
    EXPECT_GT(outcome.samples_of_a_pixel, 2) << seed;
  }
}

// A pixel alone has no neighbours and is its own lot.
TEST(ErrorControl, SmallPicturesAreLookedAtTwiceEverywhere) {
  Picture picture = half_and_half(1);
  picture.width = picture.height = 1;
  const Outcome outcome = sampled(picture, {1.0 / 255, 0}, 1);
  EXPECT_TRUE(outcome.reached);
  EXPECT_EQ(outcome.samples_of_a_pixel, 2);
}

// The bound is to hold in 95 % of the pictures: of 40 pictures, 6 or more would be beyond it with a
// probability of 1 %.
void expect_honoured(const Picture& picture, double error, const char* what) {
  int beyond_bound = 0, beyond_target = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Outcome outcome = sampled(picture, {error, 0}, seed);
    EXPECT_TRUE(outcome.reached) << what;
    EXPECT_LE(outcome.bound, error) << what;
    beyond_bound += outcome.rmse > outcome.bound ? 1 : 0;
    beyond_target += outcome.rmse > error ? 1 : 0;
  }
  EXPECT_LE(beyond_bound, 5) << what << " at " << error;
  EXPECT_LE(beyond_target, 5) << what << " at " << error;
}

TEST(ErrorControl, TheBoundHoldsForRandomNoise) {
  Picture picture = all_in_half();
  picture.is_stratified = false;
  expect_honoured(picture, 1.0 / 16, "random noise");
}

TEST(ErrorControl, TheBoundHoldsForStratifiedEdges) {
  expect_honoured(all_in_half(), 1.0 / 64, "edges everywhere");
  expect_honoured(few_edges(), 1.0 / 255, "few edges");
}

TEST(ErrorControl, TheBoundHoldsForWhatFewSamplesMiss) {
  expect_honoured(specks(), 1.0 / 255, "specks");
}

TEST(ErrorControl, TheShareOfPixelsIsHonoured) {
  int beyond = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Outcome outcome = sampled(few_edges(), {1.0 / 64, 0.99}, seed);
    EXPECT_TRUE(outcome.reached);
    beyond += outcome.share_over > 0.01 ? 1 : 0;
  }
  EXPECT_LE(beyond, 5);
}

// Random noise of variance 1/4 needs 1 / (4 E^2) samples a pixel; doubling may overshoot, and the
// confidence costs something, but not half as much again.
TEST(ErrorControl, RandomNoiseTakesTheSamplesThatItMust) {
  Picture picture = all_in_half();
  picture.is_stratified = false;
  const double error = 1.0 / 20, needed = 0.25 / (error * error);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Outcome outcome = sampled(picture, {error, 0}, seed);
    EXPECT_GE(outcome.samples_of_a_pixel, needed);
    EXPECT_LE(outcome.samples_of_a_pixel, 1.5 * needed);
  }
}

// Where most of the picture is empty, samples go where they are needed.
TEST(ErrorControl, EmptyPixelsTakeFewSamples) {
  const Outcome edges = sampled(few_edges(), {1.0 / 512, 0}, 1);
  const Outcome everywhere = sampled(all_in_half(), {1.0 / 512 * std::sqrt(13.0), 0}, 1);
  EXPECT_LT(edges.samples_of_a_pixel, everywhere.samples_of_a_pixel);
}

TEST(ErrorControl, TheSameSeedGivesTheSamePasses) {
  const Outcome a = sampled(few_edges(), {1.0 / 255, 0}, 3),
                b = sampled(few_edges(), {1.0 / 255, 0}, 3);
  EXPECT_EQ(a.rmse, b.rmse);
  EXPECT_EQ(a.bound, b.bound);
  EXPECT_EQ(a.samples_of_a_pixel, b.samples_of_a_pixel);
}

}  // namespace
}  // namespace alhazen::render
