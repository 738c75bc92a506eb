// render/color: numbers that must come out, from standards and closed forms.
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "render/color/color_config.h"
#include "render/color/preview.h"
#include "render/color/rgb_matrix.h"

namespace alhazen::render {
namespace {

ColorConfig builtin() {
  return ColorConfig::builtin().value();
}

std::array<float, 3> applied(const ColorTransform& transform, std::array<float, 3> c) {
  transform.apply({{&c[0], 1}, {&c[1], 1}, {&c[2], 1}});
  return c;
}

// IEC 61966-2-1 in double, with the straight piece that truly meets the curve with the same slope:
// 12.9232, which the standard rounds to 12.92. No byte of a preview differs.
double srgb_encoded(double linear) {
  constexpr double kExponent = 2.4, kOffset = 0.055;
  constexpr double kBreak = kOffset / (kExponent - 1);  // of the encoded value
  const double linear_break = std::pow((kBreak + kOffset) / (1 + kOffset), kExponent);
  if (linear <= linear_break) return kBreak / linear_break * linear;
  return (1 + kOffset) * std::pow(linear, 1 / kExponent) - kOffset;
}

// A chain of at most three 3x3 float matrices and a power of numbers near 1: well below 16
// roundings.
constexpr double kFloatChain = 16 * 0x1p-24;

TEST(ColorValues, UntonemappedIsTheSrgbCurveAndIsNotClamped) {
  const auto view = builtin().display_transform();
  ASSERT_TRUE(view);
  for (const double gray : {0.0, 0.001, 0.18, 0.5, 1.0, 4.0}) {
    const auto shown = applied(view.value(), {static_cast<float>(gray), static_cast<float>(gray),
                                              static_cast<float>(gray)});
    for (const float channel : shown) {
      EXPECT_NEAR(channel, srgb_encoded(gray), kFloatChain) << gray;
    }
  }
  EXPECT_NEAR(srgb_encoded(0.18), 0.461356, 5e-7);
}

TEST(ColorValues, AcesSdrMatchesTheReferenceImplementation) {
  const auto view = builtin().display_transform("sRGB", "ACES 1.0 SDR");
  ASSERT_TRUE(view);
  for (const auto& [gray, expected] :
       {std::pair{0.18F, 0.355954}, std::pair{1.0F, 0.811971}, std::pair{4.0F, 0.95528}}) {
    // The references are given to five or six digits.
    EXPECT_NEAR(applied(view.value(), {gray, gray, gray})[1], expected, 5e-6) << gray;
  }
}

TEST(ColorValues, MatrixOfChromaticitiesMatchesPublishedOnes) {
  // Academy TB-2014-004 and colour-science: linear Rec.709 to ACEScg with Bradford.
  const ColorMatrix m = rgb_from_rgb(kAcesAp1, kRec709);
  const double published[3][3] = {{0.613097, 0.339523, 0.047379},
                                  {0.070194, 0.916354, 0.013452},
                                  {0.020616, 0.109570, 0.869815}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(m.rows[i][j], published[i][j], 1e-6);
  }
  // ITU-R BT.2087-0, Rec.709 to Rec.2020: same white, so no adaptation takes part.
  const ColorMatrix wide = rgb_from_rgb(kRec2020, kRec709);
  const double bt2087[3][3] = {
      {0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0114}, {0.0164, 0.0880, 0.8956}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(wide.rows[i][j], bt2087[i][j], 5.1e-5);
  }
}

TEST(ColorValues, WorkingMatrixIsTheClosedFormAndWhiteStaysWhite) {
  const auto matrix = builtin().working_from_rec709();
  ASSERT_TRUE(matrix);
  const ColorMatrix closed_form = rgb_from_rgb(kAcesAp1, kRec709);
  // Both are a dozen products of 3x3 matrices in double with entries below 5: 1e-14 is some 50 ulp.
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(matrix.value().rows[i][j], closed_form.rows[i][j], 1e-14);
    }
  }
  const Rgbd white = matrix.value() * Rgbd(1.0);
  EXPECT_NEAR(white.r, 1.0, 1e-14);
  EXPECT_NEAR(white.g, 1.0, 1e-14);
  EXPECT_NEAR(white.b, 1.0, 1e-14);
}

TEST(ColorValues, TransformAndMatrixAgreeOnLinearRec709) {
  const ColorConfig config = builtin();
  const auto transform = config.to_working("lin_rec709");
  const auto matrix = config.working_from_rec709();
  ASSERT_TRUE(transform && matrix);
  for (const std::array<float, 3>& c :
       {std::array{1.0F, 0.0F, 0.0F}, std::array{0.0F, 1.0F, 0.0F}, std::array{0.0F, 0.0F, 1.0F},
        std::array{0.25F, 0.5F, 0.75F}}) {
    const auto by_transform = applied(transform.value(), c);
    const Rgbd by_matrix = matrix.value() * Rgbd(c[0], c[1], c[2]);
    EXPECT_NEAR(by_transform[0], by_matrix.r, kFloatChain);
    EXPECT_NEAR(by_transform[1], by_matrix.g, kFloatChain);
    EXPECT_NEAR(by_transform[2], by_matrix.b, kFloatChain);
  }
}

TEST(ColorValues, SrgbTextureIsDecodedBackToWhatWasShown) {
  const ColorConfig config = builtin();
  const auto decode = config.to_working("sRGB - Texture");
  const auto show = config.display_transform();
  ASSERT_TRUE(decode && show);
  for (const std::array<float, 3>& c :
       {std::array{1.0F, 1.0F, 1.0F}, std::array{0.0F, 0.0F, 0.0F}, std::array{0.5F, 0.25F, 1.0F},
        std::array{0.02F, 0.9F, 0.1F}}) {
    const auto shown = applied(show.value(), applied(decode.value(), c));
    // The slope of the encoding is 12.92 at black and multiplies the error of the matrices there.
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(shown[i], c[i], 13 * kFloatChain);
  }
}

TEST(ColorValues, DataIsNotTouched) {
  const ColorConfig config = builtin();
  for (const char* name : {"data", "Raw"}) {
    const auto transform = config.to_working(name);
    ASSERT_TRUE(transform);
    const std::array<float, 3> c{-3.0F, 0.123456789F, 70000.0F};
    EXPECT_EQ(applied(transform.value(), c), c);
  }
}

TEST(ColorValues, PixelsAreConvertedByThemselves) {
  const auto view = builtin().display_transform("sRGB", "ACES 1.0 SDR");
  ASSERT_TRUE(view);
  // Longer than one internal block, and not a multiple of any vector width.
  constexpr std::size_t kPixels = 5003;
  std::vector<float> r(kPixels), g(kPixels), b(kPixels);
  for (std::size_t i = 0; i < kPixels; ++i) {
    r[i] = static_cast<float>(i) / 1000.0F;
    g[i] = static_cast<float>(i % 97) / 10.0F;
    b[i] = static_cast<float>(i % 13);
  }
  auto whole_r = r, whole_g = g, whole_b = b;
  view.value().apply({whole_r, whole_g, whole_b});
  for (std::size_t i = 0; i < kPixels; ++i) {
    const auto one = applied(view.value(), {r[i], g[i], b[i]});
    ASSERT_EQ(one[0], whole_r[i]) << i;
    ASSERT_EQ(one[1], whole_g[i]) << i;
    ASSERT_EQ(one[2], whole_b[i]) << i;
  }
}

TEST(Preview, RoundsToNearestAndClamps) {
  // The Raw view shows the numbers themselves.
  const auto raw = builtin().display_transform("sRGB", "Raw");
  ASSERT_TRUE(raw);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> red{0.0F, -1.0F, 1.0F, 0.5F};  // 127.5 goes up
  const std::vector<float> green{2.0F, inf, nan, -inf};
  const std::vector<float> blue{100.4F / 255, 100.6F / 255, 0.4F / 255, 254.6F / 255};
  EXPECT_EQ(preview_rgb8(raw.value(), red, green, blue),
            (std::vector<std::uint8_t>{0, 255, 100, 0, 255, 101, 255, 0, 0, 128, 0, 255}));
}

TEST(Preview, EverySrgbByteComesBack) {
  const ColorConfig config = builtin();
  std::vector<float> r(256), g(256), b(256);
  for (std::size_t i = 0; i < 256; ++i)
    r[i] = g[i] = b[i] = static_cast<float>(i) / 255.0F;
  config.to_working("sRGB - Texture").value().apply({r, g, b});
  const auto bytes = preview_rgb8(config.display_transform().value(), r, g, b);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    EXPECT_EQ(bytes[i], i / 3);
}

TEST(TextureSpaces, ExplicitThenUseThenRuleThenExtension) {
  const ColorConfig config = builtin();
  const auto space = [&](const char* file, const char* explicit_space = "",
                         TextureUse use = TextureUse::color) {
    return config.texture_space(file, explicit_space, use).name;
  };
  EXPECT_EQ(space("a.png", "lin_rec709", TextureUse::data), "lin_rec709");
  EXPECT_EQ(space("a.png", "", TextureUse::data), "data");
  EXPECT_EQ(space("a.png"), "sRGB - Texture");
  EXPECT_EQ(space("a.PNG"), "sRGB - Texture");
  EXPECT_EQ(space("folder/a.JpEg"), "sRGB - Texture");
  EXPECT_EQ(space("env.exr"), "ACEScg");
  EXPECT_EQ(space("env.EXR"), "ACEScg");
  EXPECT_EQ(space("unknown"), "scene_linear");
  EXPECT_EQ(config.texture_space("a.png", "", TextureUse::color).reason, "file rule `png`");
}

}  // namespace
}  // namespace alhazen::render
