// tests: textures: each pattern, the choice among textures, and what collapses to one colour.
#include <gtest/gtest.h>
#include <random>

#include "render/surface/texture_table.h"

namespace alhazen::render {
namespace {

constexpr Rgbd kRed{1, 0, 0}, kBlue{0, 0, 1}, kGreen{0, 1, 0};

Texture texture(Pattern pattern, Mapping mapping = Mapping::object, Affined map = {}) {
  return {std::move(pattern), mapping, map, {}};
}

TextureTable<double> table_of(const std::vector<Texture>& textures,
                              const std::vector<ImageView>& images = {}, Vec3d offset = {}) {
  return TextureTable<double>(textures, images, offset);
}

TexturePoint<double> object_point(double x, double y, double z) {
  return {{x, y, z}, {}, 0, 0};
}
TexturePoint<double> uv_point(double u, double v) {
  return {{}, {}, u, v};
}

TEST(Texture, CheckerTakesItsCellsClosedBelow) {
  const auto table = table_of(
      {texture(SolidPattern{kRed}), texture(SolidPattern{kBlue}), texture(CheckerPattern{0, 1})});
  const auto red = [&](double x, double y, double z) {
    return table.color(2, object_point(x, y, z)) == kRed;
  };
  EXPECT_TRUE(red(0, 0, 0));
  EXPECT_TRUE(red(0.999, 0.5, 0.5));
  EXPECT_FALSE(red(1, 0.5, 0.5));
  EXPECT_FALSE(red(-1e-300, 0.5, 0.5));
  EXPECT_FALSE(red(-0.5, 0.5, 0.5));
  EXPECT_TRUE(red(-0.5, -0.5, 0.5));
  EXPECT_FALSE(red(-0.5, -0.5, -0.5));
  EXPECT_TRUE(red(0x1p60, 0.5, 0.5));  // numbers too large to have odd neighbours
  EXPECT_FALSE(red(0x1p52 + 1, 0.5, 0.5));
}

TEST(Texture, StripesLookAtXOnly) {
  const auto table = table_of(
      {texture(SolidPattern{kRed}), texture(SolidPattern{kBlue}), texture(StripesPattern{0, 1})});
  EXPECT_EQ(table.color(2, object_point(0.5, 7.5, -3)), kRed);
  EXPECT_EQ(table.color(2, object_point(1.5, 7.5, -3)), kBlue);
  EXPECT_EQ(table.color(2, object_point(-0.5, 0, 0)), kBlue);
}

struct MeasuredPoint {
  Vec3d point;
  bool is_mortar;
};
// What POV-Ray 3.7.0 says of `brick brick_size <8, 3, 4.5> mortar 0.5`, printed by its `#debug`.
// The first eight of either kind of 4000 random points, all of which agreed.
constexpr MeasuredPoint kMeasuredBrick[] = {
    {{27.235973, 6.627977, -19.988872}, false},  {{-27.907975, 14.360795, -7.021453}, true},
    {{-1.078233, 18.102981, 19.571760}, false},  {{17.724778, -24.809445, -12.145159}, false},
    {{10.807315, -1.699546, 29.406047}, false},  {{3.541938, -15.967740, -11.984257}, false},
    {{27.371261, 20.640390, -19.597948}, true},  {{-3.785325, 18.820718, 22.391739}, false},
    {{-0.576792, -0.961921, 22.289827}, true},   {{10.673318, 2.172296, 1.104489}, false},
    {{-12.300887, 21.067827, -26.363973}, true}, {{23.421525, 3.215791, -15.055368}, false},
    {{-3.634716, 17.593151, -16.635090}, true},  {{-12.915537, -3.374245, -25.383227}, true},
    {{-5.369129, -19.108706, 4.247893}, true},   {{12.383909, -27.205839, -19.854701}, true},
};

TEST(Texture, BricksAreThoseOfPovRay) {
  const auto table = table_of({texture(SolidPattern{kRed}), texture(SolidPattern{kBlue}),
                               texture(BrickPattern{0, 1, {8, 3, 4.5}, 0.5})});
  const auto is_mortar = [&](double x, double y, double z) {
    return table.color(2, object_point(x, y, z)) == kBlue;
  };
  for (const MeasuredPoint& measured : kMeasuredBrick) {
    const Vec3d p = measured.point;
    EXPECT_EQ(is_mortar(p.x, p.y, p.z), measured.is_mortar) << p.x << " " << p.y << " " << p.z;
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> where(-40, 40);
  int mortar = 0;
  for (int i = 0; i < 100000; ++i)
    mortar += is_mortar(where(random), where(random), where(random));
  // The joints fill 1 - (1 - 0.5/8)(1 - 0.5/3)(1 - 0.5/4.5) of space.
  EXPECT_NEAR(mortar / 1e5, 1 - 7.5 / 8 * 2.5 / 3 * 4 / 4.5, 0.005);
}

TEST(Texture, GradientIsLinearBetweenItsStops) {
  const GradientPattern pattern{{{0, kRed}, {1, kBlue}, {1, kGreen}, {3, kRed}}};
  const auto table = table_of({texture(pattern)});
  const auto at = [&](double x) { return table.color(0, object_point(x, 5, 5)); };
  EXPECT_EQ(at(-7), kRed);
  EXPECT_EQ(at(0), kRed);
  EXPECT_EQ(at(0.25), Rgbd(0.75, 0, 0.25));
  EXPECT_EQ(at(1), kGreen);  // a jump belongs to the later stop
  EXPECT_EQ(at(2), Rgbd(0.5, 0.5, 0));
  EXPECT_EQ(at(3), kRed);
  EXPECT_EQ(at(infinity<double>()), kRed);
}

class ImageTexture : public testing::Test {
 protected:
  // Two columns, two rows: red blue above green white.
  const std::vector<float> pixels_{1, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1};
  const std::vector<ImageView> images_{{pixels_.data(), 2, 2}};

  Rgbd at(double u, double v, ImageWrap wrap, ImageFilter filter) const {
    return table_of({texture(ImagePattern{0, wrap, filter}, Mapping::uv)}, images_)
        .color(0, uv_point(u, v));
  }
};

TEST_F(ImageTexture, TheFirstRowIsAbove) {
  for (const ImageFilter filter : {ImageFilter::nearest, ImageFilter::bilinear}) {
    EXPECT_EQ(at(0.25, 0.75, ImageWrap::repeat, filter), kRed);
    EXPECT_EQ(at(0.75, 0.75, ImageWrap::repeat, filter), kBlue);
    EXPECT_EQ(at(0.25, 0.25, ImageWrap::repeat, filter), kGreen);
  }
}

TEST_F(ImageTexture, BilinearBetweenCentres) {
  EXPECT_EQ(at(0.5, 0.75, ImageWrap::clamp, ImageFilter::bilinear), Rgbd(0.5, 0, 0.5));
  EXPECT_EQ(at(0.5, 0.5, ImageWrap::clamp, ImageFilter::bilinear), Rgbd(0.5, 0.5, 0.5));
}

TEST_F(ImageTexture, BordersAreRepeatedClampedOrMirrored) {
  const auto bilinear = ImageFilter::bilinear, nearest = ImageFilter::nearest;
  EXPECT_EQ(at(0, 0.75, ImageWrap::repeat, bilinear), Rgbd(0.5, 0, 0.5));  // across the seam
  EXPECT_EQ(at(0, 0.75, ImageWrap::clamp, bilinear), kRed);
  EXPECT_EQ(at(0, 0.75, ImageWrap::mirror, bilinear), kRed);
  EXPECT_EQ(at(1.25, 0.75, ImageWrap::repeat, nearest), kRed);
  EXPECT_EQ(at(1.25, 0.75, ImageWrap::clamp, nearest), kBlue);
  EXPECT_EQ(at(1.25, 0.75, ImageWrap::mirror, nearest), kBlue);
  EXPECT_EQ(at(-0.25, 0.75, ImageWrap::repeat, nearest), kBlue);
  EXPECT_EQ(at(-0.25, 0.75, ImageWrap::mirror, nearest), kRed);
  EXPECT_EQ(at(1, 1, ImageWrap::clamp, nearest), kBlue);
  EXPECT_EQ(at(0, 0, ImageWrap::clamp, nearest), kGreen);
}

TEST_F(ImageTexture, StrangeCoordinatesStayInThePicture) {
  for (const double x : {infinity<double>(), -infinity<double>(), std::nan(""), 1e300, -1e300,
                         -1e-320, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)}) {
    for (const ImageWrap wrap : {ImageWrap::repeat, ImageWrap::clamp, ImageWrap::mirror}) {
      for (const ImageFilter filter : {ImageFilter::nearest, ImageFilter::bilinear})
        EXPECT_TRUE(is_finite(at(x, x, wrap, filter).r)) << x;
    }
  }
}

TEST(Texture, TexturesChooseAmongTextures) {
  // A checker whose odd cells are stripes of a quarter unit.
  const auto table = table_of({texture(SolidPattern{kRed}), texture(SolidPattern{kBlue}),
                               texture(SolidPattern{kGreen}),
                               texture(StripesPattern{1, 2}, Mapping::object, scaling({4, 4, 4})),
                               texture(CheckerPattern{0, 3})});
  EXPECT_EQ(table.color(4, object_point(0.3, 0, 0)), kRed);
  EXPECT_EQ(table.color(4, object_point(1.1, 0, 0)), kBlue);
  EXPECT_EQ(table.color(4, object_point(1.3, 0, 0)), kGreen);
}

// No surface reflects more than it receives: values of a picture of floats end at 0 and 1.
TEST(Texture, PicturesAreTakenBetweenZeroAndOne) {
  const std::vector<float> two = {4.0F, -1.0F, 0.5F, std::nanf(""), 1.0F, 0.0F};
  const std::vector<float> one = {4.0F, -1.0F, 0.5F};
  const auto table = table_of(
      {texture(ImagePattern{0, ImageWrap::clamp, ImageFilter::nearest}), texture(ImagePattern{1})},
      {{two.data(), 2, 1}, {one.data(), 1, 1}});
  EXPECT_EQ(table.color(0, object_point(0.25, 0.5, 0)), Rgbd(1, 0, 0.5));
  EXPECT_EQ(table.color(0, object_point(0.75, 0.5, 0)), Rgbd(0, 1, 0));
  EXPECT_EQ(table.solid_color(1), Rgbd(1, 0, 0.5));
}

TEST(Texture, WhatShowsOneColourIsSolid) {
  const std::vector<float> gray(2 * 3 * 3, 0.25f);
  const std::vector<ImageView> images{{gray.data(), 3, 2}};
  const auto table = table_of({texture(SolidPattern{Rgbd(0.25)}),                 // 0
                               texture(ImagePattern{0}),                          // 1
                               texture(CheckerPattern{0, 1}),                     // 2
                               texture(GradientPattern{{{0, kRed}, {1, kRed}}}),  // 3
                               texture(StripesPattern{0, 3}),                     // 4: is not
                               texture(CheckerPattern{4, 4}, Mapping::uv),        // 5: is 4
                               texture(BrickPattern{2, 1})},                      // 6
                              images);
  EXPECT_EQ(table.solid_color(1), Rgbd(0.25));
  EXPECT_EQ(table.solid_color(2), Rgbd(0.25));
  EXPECT_EQ(table.solid_color(3), kRed);
  EXPECT_EQ(table.solid_color(4), std::nullopt);
  EXPECT_EQ(table.solid_color(5), std::nullopt);
  EXPECT_EQ(table.color(5, object_point(1.5, 0, 0)), kRed);
  EXPECT_EQ(table.solid_color(6), Rgbd(0.25));
}

// A world-mapped pattern that is moved with the camera by 2^k keeps its bits (docs/numerics.md F3).
TEST(Texture, WorldPatternsMoveWithTheScene) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> where(-20, 20);
  // Exact in double, as the moved frame has to be for the scene to mean the same.
  const Affined turned = rotation({0, 1, 0}, 90) * scaling({0.5, 2, 1});
  for (const double shift : {0.0, 0x1p10, 0x1p20, 0x1p40}) {
    // The pattern's frame is moved by `offset`: pattern_from_world = turned * translation(-offset).
    const Vec3d offset(shift, -shift, 3 * shift);
    const Affined moved = turned * translation(-offset);
    const auto table = table_of({texture(SolidPattern{kRed}), texture(SolidPattern{kBlue}),
                                 texture(CheckerPattern{0, 1}, Mapping::world, moved)},
                                {}, offset);
    const auto still = table_of({texture(SolidPattern{kRed}), texture(SolidPattern{kBlue}),
                                 texture(CheckerPattern{0, 1}, Mapping::world, turned)});
    for (int i = 0; i < 1000; ++i) {
      const Vec3d p(where(random), where(random), where(random));
      ASSERT_EQ(table.color(2, {{}, p, 0, 0}), still.color(2, {{}, p, 0, 0})) << shift;
    }
  }
}

}  // namespace
}  // namespace alhazen::render
