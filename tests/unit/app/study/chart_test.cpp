#include "app/study/chart.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "app/study/axis.h"
#include "app/study/label_places.h"
#include "app/study/number_text.h"

namespace alhazen {
namespace {

using testing::HasSubstr;
using testing::Not;

RC_GTEST_PROP(LogAxis, HoldsItsRangeAndHasAtLeastTwoNumbers, ()) {
  const double low = std::pow(10, *rc::gen::inRange(-160, 30) / 10.0);
  const double high = low * std::pow(10, *rc::gen::inRange(0, 120) / 10.0);
  const LogAxis axis = log_axis(low, high, number_text);
  RC_ASSERT(axis.place(low) >= 0);
  RC_ASSERT(axis.place(high) <= 1);
  RC_ASSERT(std::ranges::count_if(axis.ticks, [](const AxisTick& t) { return !t.label.empty(); }) >=
            2);
  for (std::size_t i = 1; i < axis.ticks.size(); ++i)
    RC_ASSERT(axis.ticks[i].value > axis.ticks[i - 1].value);
}

TEST(LogAxis, PlacesAreThoseOfLogarithms) {
  const LogAxis axis{0.01, 100, {}};
  EXPECT_NEAR(axis.place(0.01), 0, 1e-15);
  EXPECT_NEAR(axis.place(1), 0.5, 1e-15);
  EXPECT_NEAR(axis.place(100), 1, 1e-15);
}

RC_GTEST_PROP(LabelPlaces, NoLabelCoversAnythingOrLeaves, ()) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(0, 300), [](int v) { return 1.0 * v; });
  const auto wish = rc::gen::construct<LabelWish>(coordinate, coordinate, rc::gen::just(40.0),
                                                  rc::gen::just(12.0));
  const auto wishes = *rc::gen::container<std::vector<LabelWish>>(wish);
  const LabelBox bounds{0, 0, 300, 300};
  std::vector<LabelBox> markers;
  for (const LabelWish& w : wishes)
    markers.push_back({w.x - 4, w.y - 4, 8, 8});
  const auto places = place_labels(wishes, markers, bounds, 12);
  RC_ASSERT(places.size() == wishes.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    RC_ASSERT(places[i]->x >= 0 && places[i]->x + places[i]->width <= 300);
    RC_ASSERT(places[i]->y >= 0 && places[i]->y + places[i]->height <= 300);
    for (const LabelBox& marker : markers)
      RC_ASSERT(!overlap(*places[i], marker));
    for (std::size_t j = 0; j < i; ++j)
      RC_ASSERT(!places[j] || !overlap(*places[i], *places[j]));
  }
}

TEST(LabelPlaces, AloneALabelStandsAtTheRight) {
  const LabelWish wish{50, 50, 20, 10};
  const auto places = place_labels(std::span(&wish, 1), {}, {0, 0, 100, 100}, 12);
  ASSERT_TRUE(places[0]);
  EXPECT_GT(places[0]->x, 50);
  EXPECT_DOUBLE_EQ(places[0]->y, 45);
}

Chart two_points() {
  Chart chart;
  chart.title = "a < b";
  chart.x_title = "CPU time";
  chart.y_title = "RMSE";
  chart.width = 400;
  chart.height = 300;
  ChartSeries series{"samples", 0, Marker::circle, true, false, false, {}};
  series.points.push_back({{0.1, 0.1}, 0.09, 0.11, "<4>", "p0", "four & more", true});
  series.points.push_back({{1, 0.01}, 1, 1, "16", "p1", "sixteen", false});
  series.points.push_back({{2, 0}, 2, 2, "nothing", "p2", "no error at all", false});
  chart.series.push_back(series);
  chart.front = {{0.1, 0.1}, {1, 0.01}};
  chart.guides = usual_guides();
  chart.guides_from = {{0.1, 0.1}};
  chart.floor = 0.005;
  return chart;
}

TEST(Chart, TextOfScenesIsEscaped) {
  const std::string svg = chart_svg(two_points()).code;
  EXPECT_THAT(svg, HasSubstr("aria-label=\"a &lt; b\""));
  EXPECT_THAT(svg, HasSubstr("&lt;4&gt;"));
  EXPECT_THAT(svg, HasSubstr("four &amp; more"));
  EXPECT_THAT(svg, Not(HasSubstr("<4>")));
}

TEST(Chart, PointsLeadToTheirPicturesAndZeroHasNoPlace) {
  const std::string svg = chart_svg(two_points()).code;
  EXPECT_THAT(svg, HasSubstr("href=\"#p0\""));
  EXPECT_THAT(svg, HasSubstr("href=\"#p1\""));
  EXPECT_THAT(svg, Not(HasSubstr("href=\"#p2\"")));
  EXPECT_THAT(svg, HasSubstr("class=\"front\""));
  EXPECT_THAT(svg, HasSubstr("class=\"floor\""));
  EXPECT_THAT(svg, HasSubstr("class=\"own\""));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(Chart, WithoutPointsItSaysSo) {
  Chart chart = two_points();
  chart.series.clear();
  chart.front.clear();
  EXPECT_THAT(chart_svg(chart).code, HasSubstr("nothing can be shown"));
}

}  // namespace
}  // namespace alhazen
