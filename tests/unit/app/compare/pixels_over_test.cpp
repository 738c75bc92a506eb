#include "app/compare/pixels_over.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace alhazen {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Tolerance, IsTheLargerOfTheTwo) {
  const Tolerance tolerance{0.5, 0.25};
  EXPECT_FALSE(is_over(1.5, 1.0, tolerance));
  EXPECT_TRUE(is_over(1.5 + 1e-9, 1.0, tolerance));
  EXPECT_FALSE(is_over(-10.0, -8.0, tolerance));
  EXPECT_TRUE(is_over(-10.0 - 1e-9, -8.0, tolerance));
}

TEST(Tolerance, OfNothingLetsOnlyEqualValuesPass) {
  EXPECT_FALSE(is_over(0.0, -0.0, {}));
  EXPECT_TRUE(is_over(std::nextafter(1.0, 2.0), 1.0, {}));
}

TEST(Tolerance, NoneLetsANumberPassForNone) {
  const Tolerance wide{kInfinity, kInfinity};
  EXPECT_TRUE(is_over(kNan, 1.0, wide));
  EXPECT_TRUE(is_over(1.0, kNan, wide));
  EXPECT_TRUE(is_over(1.0, kInfinity, wide));
  EXPECT_TRUE(is_over(-kInfinity, kInfinity, wide));
  EXPECT_FALSE(is_over(kNan, kNan, {}));
  EXPECT_FALSE(is_over(kInfinity, kInfinity, {}));
}

TEST(PixelsOver, AreListedOnceWithTheirChannels) {
  const std::vector<float> a{0, 1, 2, 3, 4, 5}, same = a;
  std::vector<float> b = a, c = a;
  b[1] = 2.0F;
  b[5] = 4.5F;
  c[5] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<PlanePair> channels{{a, b}, {same, a}, {c, a}};
  const PixelsOver result = pixels_over(channels, 3, {0.25, 0.0});
  EXPECT_EQ(result.samples, 18u);
  EXPECT_EQ(result.over, 3u);
  ASSERT_EQ(result.pixels.size(), 2u);
  EXPECT_EQ(result.pixels[0].place, (PixelPlace{1, 0}));
  EXPECT_EQ(result.pixels[0].channels, 1);
  EXPECT_EQ(result.pixels[0].largest_error, 1.0);
  EXPECT_EQ(result.pixels[1].place, (PixelPlace{2, 1}));
  EXPECT_EQ(result.pixels[1].channels, 2);
  EXPECT_EQ(result.pixels[1].largest_error, kInfinity);
  EXPECT_EQ(pixels_over(channels, 3, {1.0, 0.0}).pixels.size(), 1u);
  EXPECT_TRUE(pixels_over({}, 3, {}).pixels.empty());
}

}  // namespace
}  // namespace alhazen
