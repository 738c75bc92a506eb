#include "app/compare/display_values.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace alhazen {
namespace {

render::FloatBuffer pixel(float r, float g, float b) {
  render::FloatBuffer picture(1, 1, {"B", "G", "R"});
  picture.at(2, 0, 0) = r;
  picture.at(1, 0, 0) = g;
  picture.at(0, 0, 0) = b;
  return picture;
}

Rgbd shown(float r, float g, float b, const DisplayLook& look) {
  const render::FloatBuffer light = display_light(pixel(r, g, b), {2, 1, 0}, look);
  return {light.at(0, 0, 0), light.at(1, 0, 0), light.at(2, 0, 0)};
}

TEST(DisplayValues, CurveOfSrgb) {
  EXPECT_EQ(srgb_code(0.0), 0.0);
  EXPECT_NEAR(srgb_code(1.0), 1.0, 1e-15);
  EXPECT_NEAR(srgb_light(0.5), 0.21404114048223255, 1e-15);  // ((0.5 + 0.055) / 1.055)^2.4
  // The two pieces meet to the digits that the standard rounds its constants to.
  EXPECT_NEAR(srgb_light(0.04045), srgb_light(std::nextafter(0.04045, 1.0)), 1e-7);
  for (double code = 0.0; code <= 1.0; code += 0.125)
    EXPECT_NEAR(srgb_code(srgb_light(code)), code, 1e-15);
}

TEST(DisplayValues, LightIsScaledConvertedAndClamped) {
  EXPECT_EQ(shown(0.25F, 0.5F, 4.0F, {}), Rgbd(0.25, 0.5, 1.0));
  EXPECT_EQ(shown(0.25F, 0.5F, 4.0F, {PixelEncoding::light, {}, -2.0}), Rgbd(0.0625, 0.125, 1.0));
  EXPECT_EQ(shown(-0.25F, 0.5F, 0.0F, {}), Rgbd(0.0, 0.5, 0.0));
}

TEST(DisplayValues, WhiteOfAnySpaceIsWhite) {
  const DisplayLook look{PixelEncoding::light, rec709_from(kAcesAp1), 0.0};
  const Rgbd gray = shown(0.5F, 0.5F, 0.5F, look);
  EXPECT_NEAR(gray.r, 0.5, 1e-7);
  EXPECT_NEAR(gray.g, 0.5, 1e-7);
  EXPECT_NEAR(gray.b, 0.5, 1e-7);
  // ACEScg's red is outside of Rec.709.
  EXPECT_EQ(shown(0.5F, 0.0F, 0.0F, look).g, 0.0);
}

TEST(DisplayValues, CodesAreDecoded) {
  const Rgbd light = shown(0.5F, 0.0F, 1.0F, {PixelEncoding::srgb, {}, 0.0});
  EXPECT_NEAR(light.r, 0.21404114048223255, 1e-7);
  EXPECT_EQ(light.g, 0.0);
  EXPECT_EQ(light.b, 1.0);
}

TEST(DisplayValues, WhatIsNoNumberIsShownAsFarAsItCanBe) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(shown(nan, 0.5F, infinity, {}), Rgbd(0.0, 0.5, 1.0));
  const DisplayLook look{PixelEncoding::light, rec709_from(kAcesAp1), 3.0};
  EXPECT_EQ(shown(infinity, infinity, infinity, look), Rgbd(1.0, 1.0, 1.0));
}

TEST(DisplayValues, ChromaticitiesAreReadFromTheirAttribute) {
  render::ExrPart part;
  EXPECT_EQ(chromaticities_of(part), std::nullopt);
  part.attributes["chromaticities"] = "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329";
  EXPECT_EQ(chromaticities_of(part), kRec709);
  for (const char* bad : {"", "0.64 0.33", "<box2i>", "0 0 0 0 0 0 0 0", "1 1 2 2 3 3 1 1"}) {
    part.attributes["chromaticities"] = bad;
    EXPECT_EQ(chromaticities_of(part), std::nullopt) << bad;
  }
}

}  // namespace
}  // namespace alhazen
