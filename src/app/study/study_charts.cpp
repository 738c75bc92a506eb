#include "app/study/study_charts.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/study/conclusions.h"
#include "app/study/number_text.h"

namespace alhazen {
namespace {

struct SeriesLook {
  Marker marker;
  bool has_line, is_hollow;
};

SeriesLook look_of(Knob knob) {
  switch (knob) {
    case Knob::samples:
      return {Marker::circle, true, false};
    case Knob::adaptive:
      return {Marker::square, true, false};
    case Knob::light_samples:
      return {Marker::triangle, true, false};
    case Knob::depth:
      return {Marker::diamond, true, false};
    case Knob::cutoff:
      return {Marker::point_down, true, false};
    case Knob::filter:
      return {Marker::plus, false, false};
    case Knob::precision:
      return {Marker::cross, false, false};
    case Knob::target:
      return {Marker::star, true, false};
    case Knob::povray_method_1:
      return {Marker::square, false, true};
    case Knob::povray_method_2:
    case Knob::povray_lens:
      return {Marker::diamond, false, true};
    default:
      return {Marker::triangle, false, true};
  }
}

bool is_drawn(const StudyPoint& point) {
  return point.is_shown() && point.cpu.median > 0;
}

ChartPoint chart_point(const SceneStudy& study, const StudyPoint& point, const std::string& id) {
  return {point.cost(),
          point.cpu.low,
          point.cpu.high,
          point.setting.label,
          id,
          point_text(study, point),
          point.setting.is_scene};
}

ChartSeries series_of(const SceneStudy& study, const std::vector<std::string>& ids, Knob knob) {
  const SeriesLook look = look_of(knob);
  ChartSeries series{std::string(info(knob).title),
                     static_cast<int>(knob),
                     look.marker,
                     look.has_line,
                     look.is_hollow,
                     false,
                     {}};
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const StudyPoint& point = study.points[i];
    if (point.setting.knob == knob && is_drawn(point)) {
      series.points.push_back(chart_point(study, point, ids[i]));
    }
  }
  return series;
}

// Where the slopes start: the fewest samples that are not a single ray through the centre.
std::vector<CostPoint> anchor_of(const ChartSeries& samples) {
  if (samples.points.size() < 3) return {};
  return {samples.points[1].at};
}

ChartSeries background_of(const SceneStudy& study, Knob knob) {
  ChartSeries series;
  series.is_faint = true;
  for (const StudyPoint& point : study.points) {
    if (point.setting.knob == knob || !is_drawn(point) || point.is_povray()) continue;
    if (is_comparable(study, point)) series.points.push_back(chart_point(study, point, ""));
  }
  return series;
}

// Truncation alone: the depth and the cutoff show nothing else through the noise.
KnobChart truncation_chart(const SceneStudy& study, const std::vector<std::string>& ids,
                           Knob knob) {
  KnobChart out{knob,
                std::string(info(knob).title),
                "Against the reference's depth and cutoff of the same samples: what is left out, "
                "without noise.",
                {}};
  ChartSeries series = series_of(study, ids, knob);
  series.points.clear();
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const StudyPoint& point = study.points[i];
    if (point.setting.knob != knob || !point.truncation_rmse) continue;
    ChartPoint drawn = chart_point(study, point, ids[i]);
    drawn.at.error = *point.truncation_rmse;
    if (drawn.at.error > study.truncation_error) series.points.push_back(std::move(drawn));
  }
  out.chart.y_title = "RMSE of truncation";
  out.chart.floor = study.truncation_error;
  const StudyPoint& own = study.scene_point();
  out.chart.mark = own.is_shown() ? own.errors.rmse / 10 : 0;
  out.chart.mark_label = "a tenth of the scene's error";
  out.chart.series.push_back(std::move(series));
  return out;
}

KnobChart knob_chart(const SceneStudy& study, const std::vector<std::string>& ids, Knob knob) {
  if (knob == Knob::depth || knob == Knob::cutoff) return truncation_chart(study, ids, knob);
  KnobChart out{knob, std::string(info(knob).title), std::string(info(knob).text) + ".", {}};
  out.remark[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out.remark[0])));
  out.chart.y_title = "RMSE";
  out.chart.floor = study.floor();
  out.chart.series.push_back(background_of(study, knob));
  out.chart.series.push_back(series_of(study, ids, knob));
  if (knob == Knob::samples) {
    out.chart.guides = usual_guides();
    out.chart.guides_from = anchor_of(out.chart.series.back());
  }
  return out;
}

}  // namespace

std::vector<std::string> picture_ids(const SceneStudy& study) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    std::size_t first = i;
    for (std::size_t j = 0; j < i && !study.points[i].is_povray(); ++j) {
      if (study.points[j].is_povray() ||
          !is_same(study.points[i].setting, study.points[j].setting)) {
        continue;
      }
      first = j;
      break;
    }
    ids.push_back(fmt::format("p{}", first));
  }
  return ids;
}

std::string point_text(const SceneStudy& study, const StudyPoint& point) {
  return fmt::format("{}: RMSE {} in {}", setting_text(study, point),
                     print_number(point.errors.rmse), duration_text(point.cpu.median));
}

Chart main_chart(const SceneStudy& study, bool narrow) {
  const std::vector<std::string> ids = picture_ids(study);
  Chart chart;
  chart.title = fmt::format("Error against CPU time of {}", study.name);
  chart.x_title = "CPU time";
  chart.y_title = "RMSE against the converged picture";
  chart.width = narrow ? 380 : 960;
  chart.height = narrow ? 420 : 560;
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    ChartSeries series = series_of(study, ids, static_cast<Knob>(k));
    // Other filters are other pictures; they have a chart of their own.
    if (static_cast<Knob>(k) == Knob::filter) continue;
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  for (const std::size_t i : front_of(study, false))
    chart.front.push_back(study.points[i].cost());
  chart.guides = usual_guides();
  chart.guides_from = anchor_of(series_of(study, ids, Knob::samples));
  chart.floor = study.floor();
  return chart;
}

std::vector<KnobChart> knob_charts(const SceneStudy& study) {
  const std::vector<std::string> ids = picture_ids(study);
  std::vector<KnobChart> charts;
  for (std::size_t k = 0; k < static_cast<std::size_t>(Knob::povray_method_1); ++k) {
    KnobChart chart = knob_chart(study, ids, static_cast<Knob>(k));
    if (chart.chart.series.back().points.size() < 2) continue;
    chart.chart.title = fmt::format("{} of {}", chart.heading, study.name);
    chart.chart.x_title = "CPU time";
    chart.chart.width = 400;
    chart.chart.height = 300;
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace alhazen
