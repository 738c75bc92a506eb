#include "app/study/guides.h"

#include <cmath>
#include <gtest/gtest.h>

namespace alhazen {
namespace {

constexpr CostRange kRange{0.01, 100, 1e-4, 1};

TEST(Guides, LineHasItsSlopeAndEndsAtTheEdge) {
  for (const Guide& guide : usual_guides()) {
    const auto line = guide_line(guide, {0.1, 0.1}, kRange);
    ASSERT_TRUE(line) << guide.label;
    const auto& [from, to] = *line;
    EXPECT_EQ(from.seconds, 0.1);
    EXPECT_NEAR(std::log(to.error / from.error) / std::log(to.seconds / from.seconds), -guide.slope,
                1e-12);
    const bool at_right = std::fabs(to.seconds / kRange.seconds_high - 1) < 1e-12;
    const bool at_bottom = std::fabs(to.error / kRange.error_low - 1) < 1e-9;
    EXPECT_TRUE(at_right || at_bottom) << guide.label;
    EXPECT_LE(to.seconds, kRange.seconds_high * (1 + 1e-12));
    EXPECT_GE(to.error, kRange.error_low * (1 - 1e-9));
  }
}

TEST(Guides, NoLineFromOutside) {
  EXPECT_FALSE(guide_line({0.5, ""}, {0.001, 0.1}, kRange));
  EXPECT_FALSE(guide_line({0.5, ""}, {0.1, 2}, kRange));
}

TEST(Guides, FittedSlopeIsThatOfAPowerLaw) {
  std::vector<CostPoint> points;
  for (const double n : {1.0, 4.0, 9.0, 100.0})
    points.push_back({n, 3 * std::pow(n, -0.75)});
  EXPECT_NEAR(fitted_slope(points).value(), -0.75, 1e-12);
  EXPECT_FALSE(fitted_slope({{1, 2}}));
  EXPECT_FALSE(fitted_slope({{1, 2}, {1, 3}}));
}

}  // namespace
}  // namespace alhazen
