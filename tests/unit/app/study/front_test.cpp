#include "app/study/front.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace alhazen {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

bool beats(CostPoint a, CostPoint b) {
  return a.seconds <= b.seconds && a.error <= b.error &&
         (a.seconds < b.seconds || a.error < b.error);
}

std::vector<CostPoint> some_points() {
  // Few different values, so that ties come often.
  const auto value = rc::gen::map(rc::gen::inRange(1, 8), [](int k) { return 1.0 * k; });
  return *rc::gen::container<std::vector<CostPoint>>(rc::gen::construct<CostPoint>(value, value));
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
  const CostPoint points[] = {{1, 8}, {2, 4}, {3, 5}, {4, 4}, {5, 1}};
  EXPECT_THAT(pareto_front(points), ElementsAre(0, 1, 4));
  EXPECT_THAT(pareto_front({}), IsEmpty());
}

RC_GTEST_PROP(ParetoFront, IsWhatComparingEachWithEachGives, ()) {
  const std::vector<CostPoint> points = some_points();
  const std::vector<std::size_t> front = pareto_front(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool beaten = std::ranges::any_of(
        points, [&](const CostPoint& other) { return beats(other, points[i]); });
    const bool twin = std::ranges::any_of(front, [&](std::size_t k) {
      return points[k].seconds == points[i].seconds && points[k].error == points[i].error;
    });
    RC_ASSERT(twin == !beaten);
  }
}

RC_GTEST_PROP(ParetoFront, ErrorsFallStrictlyAlongIt, ()) {
  const std::vector<CostPoint> points = some_points();
  const std::vector<std::size_t> front = pareto_front(points);
  for (std::size_t i = 1; i < front.size(); ++i) {
    RC_ASSERT(points[front[i]].seconds > points[front[i - 1]].seconds);
    RC_ASSERT(points[front[i]].error < points[front[i - 1]].error);
  }
}

TEST(TimeAtError, IsOnAStraightLineOfLogarithms) {
  const CostPoint front[] = {{1, 0.1}, {100, 0.001}};
  EXPECT_NEAR(time_at_error(front, 0.01)->seconds, 10, 1e-12);
  EXPECT_FALSE(time_at_error(front, 0.01)->at_most);
  EXPECT_DOUBLE_EQ(time_at_error(front, 0.001)->seconds, 100);
  EXPECT_DOUBLE_EQ(time_at_error(front, 0.1)->seconds, 1);
  EXPECT_FALSE(time_at_error(front, 0.1)->at_most);
}

TEST(TimeAtError, BeyondTheEndsIsSaid) {
  const CostPoint front[] = {{1, 0.1}, {100, 0.001}};
  EXPECT_TRUE(time_at_error(front, 0.5)->at_most);
  EXPECT_DOUBLE_EQ(time_at_error(front, 0.5)->seconds, 1);
  EXPECT_FALSE(time_at_error(front, 0.0009));
  EXPECT_FALSE(time_at_error({}, 1));
}

}  // namespace
}  // namespace alhazen
