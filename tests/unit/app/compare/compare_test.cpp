#include "app/compare/compare.h"

#include <cmath>
#include <gmock/gmock.h>

#include "app/compare/difference_picture.h"
#include "app/compare/report_json.h"
#include "app/compare/report_text.h"
#include "app/compare/report_values.h"
#include "unit/app/compare/pictures.h"

namespace alhazen {
namespace {

using testing::HasSubstr;

ComparedPicture colors_and_depth(int width = 16, int height = 12) {
  return test_picture(
      {test_part("rgba", {"A", "B", "G", "R"}, width, height),
       test_part("data", {"CryptoObject00.g", "CryptoObject00.r", "Z"}, width, height)});
}

Comparison compare(const ComparedPicture& a, const ComparedPicture& b,
                   const CompareSettings& settings = {}) {
  const Result<Comparison> result = compare_pictures(a, b, settings);
  EXPECT_TRUE(result);
  return result ? result.value() : Comparison{};
}

TEST(Compare, EqualPicturesPass) {
  const ComparedPicture a = colors_and_depth(), b = a;
  const Comparison comparison = compare(a, b);
  EXPECT_TRUE(comparison.passed());
  ASSERT_EQ(comparison.parts.size(), 2u);
  const LayerComparison& colors = comparison.parts[0].layers.at(0);
  EXPECT_EQ(colors.name, "RGB");
  EXPECT_EQ(colors.visible.value().ssim, 1.0);
  EXPECT_EQ(colors.visible.value().flip.mean, 0.0);
  EXPECT_EQ(verdict(comparison), "A and B are the same: no value differs by more than 0");
}

TEST(Compare, ChannelsMayStandInAnotherOrderInTheOtherPicture) {
  ComparedPicture a = test_picture({test_part("", {"B", "G", "R"}, 16, 12)});
  ComparedPicture b = test_picture({test_part("", {"R", "B", "G"}, 16, 12)});
  for (int i = 0; i < 16 * 12; ++i) {
    for (const char* name : {"R", "G", "B"}) {
      const float value = static_cast<float>((i + *name) % 17) / 17.0F;
      a.parts[0].pixels.at(*a.parts[0].pixels.find(name), i % 16, i / 16) = value;
      b.parts[0].pixels.at(*b.parts[0].pixels.find(name), i % 16, i / 16) = value;
    }
  }
  const Comparison comparison = compare(a, b);
  EXPECT_TRUE(comparison.passed());
  EXPECT_EQ(comparison.parts[0].layers[0].visible->flip.mean, 0.0);
  EXPECT_EQ(comparison.parts[0].layers[0].visible->ssim, 1.0);
}

TEST(Compare, OnePixelIsFoundInItsChannelItsLayerAndItsPart) {
  ComparedPicture a = colors_and_depth();
  const ComparedPicture b = a;
  a.parts[0].pixels.at(2, 5, 7) += 0.5F;  // G
  const Comparison comparison = compare(a, b);
  EXPECT_FALSE(comparison.passed());
  const PartComparison& part = comparison.parts[0];
  EXPECT_EQ(part.channels.at(0).figures.over, 0u);  // R
  EXPECT_EQ(part.channels.at(1).channel.name, "G");
  EXPECT_EQ(part.channels.at(1).figures.mse, 0.25 / (16 * 12));
  EXPECT_EQ(part.layers.at(0).figures.mse, 0.25 / (3 * 16 * 12));
  EXPECT_EQ(part.layers.at(0).figures.largest.place, (PixelPlace{5, 7}));
  ASSERT_EQ(part.over.pixels.size(), 1u);
  EXPECT_EQ(part.over.pixels[0].place, (PixelPlace{5, 7}));
  EXPECT_EQ(comparison.pixels_over(), 1u);
  EXPECT_EQ(verdict(comparison), "A and B differ by more than 0: in part rgba 1 of 192 pixels");
  CompareSettings wide;
  wide.tolerance.absolute = 0.5;
  EXPECT_TRUE(compare(a, b, wide).passed());
}

TEST(Compare, PlacesAreThoseOfThePictureAndNotOfTheCrop) {
  ComparedPicture a = colors_and_depth();
  for (render::ExrPart& part : a.parts)
    part.data_window.x = 100;
  const ComparedPicture b = a;
  a.parts[0].pixels.at(2, 5, 7) += 0.5F;
  const Comparison comparison = compare(a, b);
  EXPECT_THAT(comparison_text(comparison, a, b), HasSubstr("(105, 7)"));
  const auto json = comparison_json(comparison, a, b);
  EXPECT_EQ(json["parts"][0]["first_pixels_over"][0]["at"], nlohmann::json({105, 7}));
}

TEST(Compare, IdsAreEqualOrNotWhateverTheTolerance) {
  ComparedPicture a = colors_and_depth();
  const ComparedPicture b = a;
  a.parts[1].pixels.at(1, 3, 2) = 1e25F;
  CompareSettings wide;
  wide.tolerance = {1e38, 1.0};
  const Comparison comparison = compare(a, b, wide);
  EXPECT_EQ(comparison.pixels_over(), 1u);
  const Figures& ids = comparison.parts[1].channels.at(0).figures;
  EXPECT_EQ(ids.over, 1u);
  EXPECT_TRUE(std::isnan(ids.mse));
  EXPECT_EQ(comparison.parts[1].layers.at(0).figures.mse, 0.0);  // of the shares alone
}

TEST(Compare, ShapeAloneFails) {
  const ComparedPicture a = colors_and_depth();
  ComparedPicture b = a;
  b.parts.pop_back();
  const Comparison comparison = compare(a, b);
  EXPECT_FALSE(comparison.passed());
  EXPECT_EQ(comparison.pixels_over(), 0u);
  EXPECT_THAT(verdict(comparison), HasSubstr("differ in shape"));
}

TEST(Compare, ExposureBringsDarkDifferencesIntoSight) {
  ComparedPicture a = test_picture({test_part("", {"B", "G", "R"}, 16, 12)});
  for (std::size_t c = 0; c < 3; ++c) {
    for (float& sample : a.parts[0].pixels.channel(c))
      sample = 1.0F / 1024.0F;
  }
  ComparedPicture b = a;
  for (float& sample : b.parts[0].pixels.channel(1))
    sample = 2.0F / 1024.0F;
  CompareSettings bright;
  bright.exposure = 9.0;
  const double dark_flip = compare(a, b).parts[0].layers[0].visible->flip.mean;
  EXPECT_GT(compare(a, b, bright).parts[0].layers[0].visible->flip.mean, 5.0 * dark_flip);
}

TEST(Compare, JsonHasNoNumberForWhatIsNone) {
  ComparedPicture a = colors_and_depth(), b = a;
  a.parts[1].pixels.at(2, 0, 1) = std::nanf("");
  const Comparison comparison = compare(a, b);
  const std::string text = comparison_json(comparison, a, b).dump();
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["passed"], false);
  const auto& rgb = json["parts"][0]["layers"][0];
  EXPECT_EQ(rgb["figures"]["psnr"], "infinite");
  EXPECT_EQ(rgb["ssim"], 1.0);
  const auto& ids = json["parts"][1]["channels"][0];
  EXPECT_EQ(ids["name"], "CryptoObject00.r");
  EXPECT_TRUE(ids["figures"]["mse"].is_null());
  const auto& depth = json["parts"][1]["channels"][2]["figures"];
  EXPECT_EQ(depth["odd"]["nan_in_a"]["count"], 1);
  EXPECT_EQ(depth["odd"]["nan_in_a"]["first"], nlohmann::json({0, 1}));
  EXPECT_EQ(depth["compared"], 16 * 12 - 1);
  EXPECT_THAT(comparison_text(comparison, a, b),
              HasSubstr("Z: 1 x NaN in A only; the first at (0, 1)"));
}

TEST(DifferencePicture, IsSignedAndHasFlip) {
  ComparedPicture a = colors_and_depth();
  const ComparedPicture b = a;
  a.parts[0].pixels.at(2, 5, 7) -= 2.0F;          // G: to 0.125, which a display shows
  a.parts[0].pixels.at(0, 1, 1) = std::nanf("");  // A
  a.parts[1].pixels.at(2, 3, 2) = 100.125F;       // Z
  const Comparison comparison = compare(a, b);
  const Result<DifferencePicture> result = difference_picture(comparison);
  ASSERT_TRUE(result);
  const render::ExrFile& file = result.value().file;
  EXPECT_EQ(file.beauty.names(), (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(file.beauty.at(1, 5, 7), -2.0F);
  EXPECT_EQ(file.beauty.at(0, 5, 7), 0.0F);
  EXPECT_EQ(file.data.at(file.data.find("Z").value(), 3, 2), 98.0F);
  EXPECT_GT(file.data.at(file.data.find("FLIP.E").value(), 5, 7), 0.0F);
  EXPECT_TRUE(std::isnan(file.data.at(file.data.find("A").value(), 1, 1)));
}

TEST(DifferencePicture, OfTwoPartsWithTheSameChannelsKeepsBoth) {
  const ComparedPicture a =
      test_picture({test_part("left", {"B", "G", "R"}), test_part("right", {"B", "G", "R"})});
  const Comparison comparison = compare(a, a);
  const Result<DifferencePicture> result = difference_picture(comparison);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result.value().file.data.find("right.G"));
  EXPECT_TRUE(result.value().file.data.find("right.FLIP.E"));
}

TEST(DifferencePicture, OfNothingIsAnError) {
  const ComparedPicture a = test_picture({test_part("", {"R"})});
  const ComparedPicture b = test_picture({test_part("", {"Z"})});
  const Result<DifferencePicture> result = difference_picture(compare(a, b));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace alhazen
