// app/study: the page that leads to those of several scenes.
#include <fmt/format.h>

#include "app/page/base64.h"
#include "app/page/page.h"
#include "app/page/table.h"
#include "app/study/conclusions.h"
#include "app/study/number_text.h"
#include "app/study/page_look.h"
#include "app/study/report_page.h"
#include "app/study/study_charts.h"

namespace alhazen {
namespace {

Html link(const IndexEntry& entry) {
  return html_element("a", html_text(entry.study.name), {{"href", entry.file}});
}

Html cell(const std::string& text) {
  return html_text(text);
}

Html overview(std::span<const IndexEntry> entries) {
  HtmlTable table;
  table.columns = {{"scene"},
                   {"pixels", true},
                   {"own settings"},
                   {"CPU", true},
                   {"RMSE", true},
                   {"over 1/255", true, "pixels with a channel that is off by more"},
                   {"halving costs", true, "times the time of the own settings"},
                   {"float / double", true, "how many times larger float's rounding error is"}};
  for (const IndexEntry& entry : entries) {
    const SceneStudy& study = entry.study;
    const StudyPoint& own = study.scene_point();
    const auto half = halving_cost(study);
    const auto gain = study.rounding ? study.rounding->gain() : std::nullopt;
    table.rows.push_back(
        {link(entry), cell(fmt::format("{} \u00d7 {}", study.width, study.height)),
         cell(setting_text(study, own)), cell(duration_text(own.cpu.median)),
         cell(own.is_shown() ? print_number(own.errors.rmse) : "< " + print_number(own.floor)),
         cell(percent_text(own.errors.share_over())), cell(half ? ratio_text(*half) : "\u2013"),
         cell(gain ? print_number(*gain) : "\u2013")});
  }
  return html_table(table);
}

Html equal_table(std::span<const IndexEntry> entries) {
  HtmlTable table;
  table.columns = {{"scene"}};
  for (const double error : kEqualErrors) {
    table.columns.push_back({fmt::format("Alhazen, {}", print_number(error)), true});
    table.columns.push_back({"POV-Ray", true});
    table.columns.push_back({"ratio", true, "POV-Ray's time to ours"});
  }
  bool any = false;
  for (const IndexEntry& entry : entries) {
    if (!entry.study.povray || !entry.study.povray->failure.empty()) continue;
    any = true;
    std::vector<Html> row = {link(entry)};
    for (const EqualError& equal : equal_errors(entry.study)) {
      const auto ratio = equal.ratio();
      row.push_back(cell(time_text(equal.ours)));
      row.push_back(cell(time_text(equal.povray)));
      row.push_back(cell(ratio ? ratio_text(*ratio) : "\u2013"));
    }
    table.rows.push_back(std::move(row));
  }
  if (!any) return {};
  return html_line("h2", "The same error in POV-Ray") +
         html_line("p",
                   "CPU time until the RMSE is reached, by a straight line between the points "
                   "of each program's Pareto front.") +
         html_table(table);
}

Html charts(std::span<const IndexEntry> entries) {
  Html parts;
  for (const IndexEntry& entry : entries) {
    Chart chart = main_chart(entry.study, true);
    for (ChartSeries& series : chart.series) {
      for (ChartPoint& point : series.points)
        point.label.clear();
    }
    parts +=
        html_element("section", html_element("h3", link(entry)) +
                                    html_element("div", chart_svg(chart), {{"class", "chart"}}));
  }
  return html_element("div", parts, {{"class", "knobs"}});
}

}  // namespace

Result<std::string> study_index(std::span<const IndexEntry> entries) {
  Html body =
      html_line("p", "Error against CPU time, scene by scene; each name leads to its page.");
  body += overview(entries) + equal_table(entries);
  body += html_line("h2", "At a glance") + charts(entries);
  return html_page("What accuracy costs", body, study_page_extras());
}

}  // namespace alhazen
