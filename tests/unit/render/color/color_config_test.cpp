#include "render/color/color_config.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

#include "core/base/file.h"
#include "unit/render/temporary_folder.h"

namespace alhazen::render {
namespace {

class ColorConfigTest : public testing::Test {
 protected:
  // Opens a configuration of this text as --ocio would.
  Result<ColorConfig> open_text(const std::string& text) const {
    const auto file = folder_.path() / "config.ocio";
    EXPECT_TRUE(write_file_atomic(file, text));
    return ColorConfig::open({file.string(), ""});
  }
  static ColorConfig builtin() {
    Result<ColorConfig> config = ColorConfig::builtin();
    EXPECT_TRUE(config) << (config ? "" : config.error().message);
    return std::move(config).value();
  }

  const TemporaryFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// The message of the error that `result` must hold.
template <class T>
std::string message(const Result<T>& result) {
  EXPECT_FALSE(result);
  return result ? "" : result.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(ColorConfigTest, BuiltinHasWhatPeopleExpect) {
  const ColorConfig config = builtin();
  EXPECT_EQ(config.origin(), "built-in");
  EXPECT_EQ(config.working_space(), "ACEScg");
  EXPECT_EQ(config.working_chromaticities(), kAcesAp1);
  const auto displays = config.displays();
  ASSERT_EQ(displays.size(), 1u);
  EXPECT_EQ(displays[0].display, "sRGB");
  EXPECT_EQ(displays[0].default_view, "Un-tone-mapped");
  EXPECT_EQ(displays[0].views, (std::vector<std::string>{"Un-tone-mapped", "ACES 1.0 SDR", "Raw"}));
}

TEST_F(ColorConfigTest, SerializedBuiltinIsAConfigurationOfItsOwn) {
  const std::string text = builtin().serialize();
  const auto reopened = open_text(text);
  ASSERT_TRUE(reopened) << reopened.error().message;
  EXPECT_EQ(reopened.value().serialize(), text);
  EXPECT_EQ(reopened.value().working_chromaticities(), kAcesAp1);
  EXPECT_TRUE(contains(reopened.value().origin(), "--ocio"));
}

TEST_F(ColorConfigTest, ExplicitFileWinsOverEnvironmentWinsOverBuiltin) {
  const auto file = (folder_.path() / "config.ocio").string();
  ASSERT_TRUE(write_file_atomic(file, builtin().serialize()));
  EXPECT_TRUE(contains(ColorConfig::open({file, "/nowhere"}).value().origin(), "--ocio"));
  EXPECT_TRUE(contains(ColorConfig::open({"", file}).value().origin(), "$OCIO"));
  EXPECT_EQ(ColorConfig::open({"", ""}).value().origin(), "built-in");

  ASSERT_EQ(::setenv("OCIO", "some.ocio", 1), 0);
  EXPECT_EQ(color_source("").environment_file, "some.ocio");
  ASSERT_EQ(::unsetenv("OCIO"), 0);
  EXPECT_EQ(color_source("x").environment_file, "");
  EXPECT_EQ(color_source("x").explicit_file, "x");
}

TEST_F(ColorConfigTest, BrokenConfigurationIsAnErrorAndNothingIsPrinted) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto missing = ColorConfig::open({"", (folder_.path() / "missing.ocio").string()});
  EXPECT_TRUE(contains(message(missing), "$OCIO"));
  EXPECT_TRUE(contains(message(missing), "missing.ocio"));
  EXPECT_EQ(missing.error().code, ErrorCode::io);
  EXPECT_TRUE(contains(message(ColorConfig::open({folder_.path().string(), ""})), "is a folder"));
  EXPECT_FALSE(ColorConfig::open({"ocio://default", ""}));
  EXPECT_FALSE(open_text(""));
  EXPECT_FALSE(open_text("{{{ not a configuration"));
  const std::string good = builtin().serialize();
  EXPECT_FALSE(open_text(good.substr(0, good.size() / 2)));
  // Valid YAML, but a view in a colour space that is not there.
  EXPECT_FALSE(open_text(
      replaced(good, "display_colorspace: sRGB - Display", "display_colorspace: nowhere")));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(ColorConfigTest, ConfigurationWithoutSceneLinearSaysSo) {
  const auto config = open_text(replaced(builtin().serialize(), "  scene_linear: ACEScg\n", ""));
  EXPECT_TRUE(contains(message(config), "no role `scene_linear`"));
  EXPECT_TRUE(contains(message(config), "`rendering`")) << "lists the roles there are";
}

TEST_F(ColorConfigTest, UnknownNamesListTheKnownOnes) {
  const ColorConfig config = builtin();
  const auto display = config.display_transform("P3");
  EXPECT_TRUE(contains(message(display), "no display `P3`"));
  EXPECT_TRUE(contains(message(display), "`sRGB`"));
  EXPECT_EQ(display.error().code, ErrorCode::usage);
  EXPECT_TRUE(contains(message(config.display_transform("sRGB", "Filmic")), "`ACES 1.0 SDR`"));
  EXPECT_TRUE(contains(message(config.to_working("Filmic Log")), "`Linear Rec.709 (sRGB)`"));
  EXPECT_TRUE(config.display_transform("srgb", "aces 1.0 sdr")) << "names in any case";
  EXPECT_TRUE(config.to_working("LIN_REC709")) << "aliases in any case";
  EXPECT_TRUE(config.to_working("texture_paint")) << "roles";
}

TEST_F(ColorConfigTest, ForeignWorkingSpaceIsReachedThroughTheInterchangeRole) {
  const std::string foreign = replaced(builtin().serialize(), "  scene_linear: ACEScg\n",
                                       "  scene_linear: Linear Rec.709 (sRGB)\n");
  const auto config = open_text(foreign);
  ASSERT_TRUE(config) << config.error().message;
  EXPECT_EQ(config.value().working_space(), "Linear Rec.709 (sRGB)");
  EXPECT_EQ(config.value().working_chromaticities(), kRec709);
  const auto matrix = config.value().working_from_rec709();
  ASSERT_TRUE(matrix);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      // There and back through AP0 in double; the largest factors are below 3.
      EXPECT_NEAR(matrix.value().rows[i][j], i == j ? 1.0 : 0.0, 1e-14);
    }
  }
}

TEST_F(ColorConfigTest, ForeignConfigurationMayUseTheNamesOfTheBuiltinOne) {
  const std::string foreign = replaced(
      builtin().serialize(), "name: sRGB - Texture\n    aliases: [srgb_texture, srgb_tx, sRGB]",
      "name: Encoded Picture\n    aliases: []");
  std::string renamed = foreign;
  for (std::size_t at; (at = renamed.find(": sRGB - Texture")) != std::string::npos;) {
    renamed.replace(at, 16, ": Encoded Picture");
  }
  for (std::size_t at; (at = renamed.find("colorspace: sRGB - Texture")) != std::string::npos;) {
    renamed.replace(at, 26, "colorspace: Encoded Picture");
  }
  const auto config = open_text(renamed);
  ASSERT_TRUE(config) << config.error().message;
  const auto borrowed = config.value().to_working("sRGB - Texture");
  const auto own = config.value().to_working("Encoded Picture");
  ASSERT_TRUE(borrowed && own);
  float a[3] = {0.25F, 0.5F, 0.75F}, b[3] = {0.25F, 0.5F, 0.75F};
  borrowed.value().apply({{a, 1}, {a + 1, 1}, {a + 2, 1}});
  own.value().apply({{b, 1}, {b + 1, 1}, {b + 2, 1}});
  // The way through AP0 is one matrix more: three roundings of numbers below 1.
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], 4 * 0x1p-24);
}

TEST_F(ColorConfigTest, WithoutInterchangeRoleThereIsNoWayAndItIsSaid) {
  const auto config =
      open_text(replaced(builtin().serialize(), "  aces_interchange: ACES2065-1\n", ""));
  ASSERT_TRUE(config) << config.error().message;
  EXPECT_TRUE(contains(message(config.value().working_from_rec709()), "`aces_interchange`"));
  EXPECT_EQ(config.value().working_chromaticities(), std::nullopt);
  EXPECT_TRUE(config.value().display_transform()) << "its own conversions still work";
}

TEST_F(ColorConfigTest, WorkingSpaceThatIsNotLinearHasNoMatrix) {
  const auto config = open_text(replaced(builtin().serialize(), "  scene_linear: ACEScg\n",
                                         "  scene_linear: sRGB - Texture\n"));
  ASSERT_TRUE(config) << config.error().message;
  EXPECT_TRUE(contains(message(config.value().working_from_rec709()), "not linear"));
}

}  // namespace
}  // namespace alhazen::render
