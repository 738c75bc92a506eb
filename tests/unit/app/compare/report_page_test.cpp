#include "app/compare/report_page.h"

#include <gmock/gmock.h>

#include "app/compare/color_ramp.h"
#include "app/compare/flip_color.h"
#include "unit/app/compare/pictures.h"

namespace alhazen {
namespace {

using testing::HasSubstr;
using testing::Not;

PageView builtin_view() {
  return PageView::make(render::ColorConfig::builtin().value(), "", "").value();
}

TEST(ColorRamp, LightnessGrowsWithTheValue) {
  double before = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const auto color = ramp_color(i / 100.0);
    const Rgbd light(srgb_light(color[0] / 255.0), srgb_light(color[1] / 255.0),
                     srgb_light(color[2] / 255.0));
    const double lightness = lab_of_xyz(xyz_of_light(light)).r;
    EXPECT_GE(lightness, before) << i;
    before = lightness;
  }
  EXPECT_GT(before, 95.0);
  EXPECT_EQ(ramp_color(-1.0), ramp_color(0.0));
  EXPECT_EQ(ramp_color(7.0), ramp_color(1.0));
  EXPECT_EQ(ramp_color(std::nan("")), ramp_color(0.0));
}

TEST(PageView, ShowsLightAsPreviewsDo) {
  // Half the light of white, of any primaries, is code 188 of sRGB: 255 * 0.7354.
  render::FloatBuffer gray(1, 1, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c)
    gray.at(c, 0, 0) = 0.5F;
  const DisplayLook look{PixelEncoding::light, rec709_from(kAcesAp1), 0.0};
  EXPECT_THAT(builtin_view().shown(gray, {0, 1, 2}, look), testing::ElementsAre(188, 188, 188));
  const DisplayLook stop_up{PixelEncoding::light, rec709_from(kAcesAp1), 1.0};
  EXPECT_THAT(builtin_view().shown(gray, {0, 1, 2}, stop_up), testing::ElementsAre(255, 255, 255));
}

TEST(PageView, ShowsCodesAsTheyAre) {
  render::FloatBuffer codes(256, 1, {"R", "G", "B"});
  std::vector<std::uint8_t> expected;
  for (int i = 0; i < 256; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      codes.at(c, i, 0) = static_cast<float>(i) / 255.0F;
      expected.push_back(static_cast<std::uint8_t>(i));
    }
  }
  EXPECT_EQ(builtin_view().shown(codes, {0, 1, 2}, {PixelEncoding::srgb, {}, 0.0}), expected);
}

TEST(PageView, GainTakesMostDifferencesToHalf) {
  ComparedPicture a = test_picture({test_part("", {"B", "G", "R"}, 100, 3)});
  const ComparedPicture b = a;
  for (int x = 0; x < 100; ++x)
    a.parts[0].pixels.at(1, x, 0) += 0.03125F;  // 1/32
  a.parts[0].pixels.at(1, 50, 0) += 1000.0F;    // an outlier
  const PartPair parts{&a.parts[0], &b.parts[0], {}};
  const std::array<ChannelPair, 3> channels{{{"R", 2, 2}, {"G", 1, 1}, {"B", 0, 0}}};
  EXPECT_EQ(difference_gain(parts, channels), 16.0);
  const auto shown = shown_difference(parts, channels, 16.0, PixelEncoding::light);
  EXPECT_EQ(shown[1], 188);           // G of the first pixel: half
  EXPECT_EQ(shown[3 * 50 + 1], 255);  // the outlier
  EXPECT_EQ(shown[3 * 100 + 1], 0);   // the next row is equal
  // Five in a hundred count: 1/4 wants no gain but 2.
  for (int x = 0; x < 5; ++x)
    a.parts[0].pixels.at(2, x, 0) += 0.25F;
  EXPECT_EQ(difference_gain(parts, channels), 2.0);
  const PartPair same{&b.parts[0], &b.parts[0], {}};
  EXPECT_EQ(difference_gain(same, channels), 1.0);
}

TEST(ReportPage, HoldsPicturesFiguresAndWhatDiffersInShape) {
  ComparedPicture a =
      test_picture({test_part("rgba", {"B", "G", "R"}, 16, 12), test_part("data", {"Z"}, 16, 12)});
  a.name = "folder/<a>.exr";
  ComparedPicture b = a;
  b.name = "b.exr";
  b.parts[1].pixels.at(0, 3, 4) = 7.0F;
  b.parts.push_back(test_part("more", {"N.X"}));
  const Result<Comparison> comparison = compare_pictures(a, b, {});
  ASSERT_TRUE(comparison);
  const Result<std::string> page = comparison_page(comparison.value(), a, b, builtin_view());
  ASSERT_TRUE(page);
  EXPECT_THAT(page.value(), HasSubstr("&lt;a&gt;.exr and b.exr"));
  EXPECT_THAT(page.value(), Not(HasSubstr("<a>.exr")));
  EXPECT_THAT(page.value(), HasSubstr("part `more` is in B only (N.X)"));
  EXPECT_THAT(page.value(), HasSubstr("SSIM 1, FLIP 0"));
  EXPECT_THAT(page.value(), HasSubstr("(3, 4)"));
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.value().find("<img ", at)) != std::string::npos; ++at)
    ++pictures;
  EXPECT_EQ(pictures, 5u);  // A, B, difference, FLIP; and the difference of Z
}

}  // namespace
}  // namespace alhazen
