#include "app/study/report_sections.h"

#include <cmath>
#include <fmt/format.h>

#include "app/page/table.h"
#include "app/study/conclusions.h"
#include "app/study/number_text.h"
#include "app/study/study_charts.h"

namespace alhazen {
namespace {

Html cell(const std::string& text) {
  return html_text(text);
}

std::string count_text(std::uint64_t count) {
  if (count >= 10'000'000) return fmt::format("{:.3g} M", 1e-6 * static_cast<double>(count));
  if (count >= 10'000) return fmt::format("{:.3g} k", 1e-3 * static_cast<double>(count));
  return fmt::format("{}", count);
}

std::string rmse_text(const StudyPoint& point) {
  return point.is_shown() ? print_number(point.errors.rmse) : "< " + print_number(point.floor);
}

std::string spread_text(const Spread& spread) {
  return fmt::format("{} \u2013 {}", duration_text(spread.low), duration_text(spread.high));
}

std::vector<Html> row_of(const SceneStudy& study, const StudyPoint& p) {
  const render::RenderStatistics& s = p.statistics;
  const auto ours = [&](const std::string& text) { return cell(p.is_povray() ? "" : text); };
  return {cell(std::string(info(p.setting.knob).title)),
          cell(setting_text(study, p)),
          cell(duration_text(p.cpu.median)),
          cell(spread_text(p.cpu)),
          cell(duration_text(p.wall.median)),
          cell(rmse_text(p)),
          cell(p.truncation_rmse ? print_number(*p.truncation_rmse) : ""),
          cell(print_number(p.errors.relative_mse)),
          cell(print_number(p.errors.largest)),
          cell(percent_text(p.errors.share_over())),
          cell(print_number(p.errors.flip)),
          ours(fmt::format("{:.3g}", p.samples_a_pixel)),
          ours(count_text(s.camera_rays)),
          ours(count_text(s.reflection_rays)),
          ours(count_text(s.refraction_rays)),
          ours(count_text(s.shadow_rays))};
}

std::string filters_text(const SceneStudy& study) {
  std::string text;
  for (const FilterReference& reference : study.filter_references) {
    text += fmt::format("{}{} ({} samples, own error {})", text.empty() ? "" : ", ",
                        setting_name(reference.filter), reference.samples,
                        print_number(reference.own_error));
  }
  return text.empty() ? "" : fmt::format(" Other filters have references of their own: {}.", text);
}

}  // namespace

std::string size_text(const SceneStudy& study) {
  std::string own;
  const double ratio = static_cast<double>(study.own_width) * study.own_height /
                       (static_cast<double>(study.width) * study.height);
  if (study.own_width != study.width || study.own_height != study.height) {
    own = fmt::format(
        " (the scene's own {} \u00d7 {} have {} times as many, and take about as much "
        "longer)",
        study.own_width, study.own_height, ratio_text(ratio));
  }
  return fmt::format("{} \u00d7 {} pixels{}, {} thread{}, {}.", study.width, study.height, own,
                     study.threads, study.threads == 1 ? "" : "s", render::info(study.isa).name);
}

Html points_table(const SceneStudy& study) {
  HtmlTable table;
  table.columns = {
      {"curve"},
      {"settings"},
      {"CPU", true, "median of the runs, of the whole process"},
      {"from \u2013 to", true, "the quickest and the slowest run"},
      {"wall", true, "median"},
      {"RMSE", true, "against the converged picture"},
      {"truncation", true, "RMSE against the reference's depth and cutoff, same samples"},
      {"relative MSE", true, "mean of (a \u2212 b)\u00b2 / (b\u00b2 + 0.01)"},
      {"largest", true, "of |a \u2212 b|"},
      {"over 1/255", true, "pixels with a channel that is off by more"},
      {"FLIP", true, "mean: how visible it is when both alternate"},
      {"samples", true, "a pixel, on average"},
      {"camera", true, "rays"},
      {"reflected", true, "rays"},
      {"refracted", true, "rays"},
      {"shadow", true, "rays"}};
  for (const StudyPoint& point : study.points)
    table.rows.push_back(row_of(study, point));
  return html_table(table);
}

Html rounding_section(const SceneStudy& study) {
  if (!study.rounding) return {};
  HtmlTable table;
  table.columns = {{"scalar type"},
                   {"CPU", true},
                   {"RMSE", true, "against quad, the same samples"},
                   {"largest", true},
                   {"over 1/255", true}};
  for (const RoundingPoint& p : study.rounding->points) {
    table.rows.push_back({cell(std::string(setting_name(p.precision))),
                          cell(duration_text(p.cpu.median)), cell(print_number(p.errors.rmse)),
                          cell(print_number(p.errors.largest)),
                          cell(percent_text(p.errors.share_over()))});
  }
  Html html = html_line("h2", "Rounding error");
  html +=
      html_line("p", fmt::format("The same {} sample{} of every pixel in each scalar type, "
                                 "against __float128. Most of float's error is not in the "
                                 "last digits of colours: it is where a ray near an edge falls "
                                 "on its other side.",
                                 study.rounding->samples, study.rounding->samples == 1 ? "" : "s"));
  return html + html_table(table);
}

Html povray_section(const SceneStudy& study) {
  if (!study.povray) return {};
  const PovrayStudy& povray = *study.povray;
  Html html = html_line("h2", "POV-Ray");
  if (!povray.failure.empty()) {
    html += html_line("p", "There are no points of POV-Ray's: " + povray.failure);
    return html;
  }
  html += html_line(
      "p",
      fmt::format("POV-Ray 3.7 with the scene's depth and cutoff, against {}; its times are of "
                  "tracing alone, as it tells them. Its pictures are half floats, which "
                  "rounds by 2^\u221212 of the value.{}",
                  povray.reference,
                  povray.own_reference
                      ? fmt::format(" It cannot say the scene exactly: converged, its picture is "
                                    "{} (RMSE) from ours.",
                                    print_number(povray.from_ours))
                      : ""));
  for (const std::string& deviation : povray.deviations)
    html += html_line("p", "Not exact: " + deviation, {{"class", "quiet"}});
  HtmlTable table;
  table.columns = {
      {"RMSE", true}, {"Alhazen", true}, {"POV-Ray", true}, {"POV-Ray / Alhazen", true}};
  for (const EqualError& row : equal_errors(study)) {
    const auto ratio = row.ratio();
    table.rows.push_back({cell(print_number(row.rmse)), cell(time_text(row.ours)),
                          cell(time_text(row.povray)),
                          cell(ratio ? ratio_text(*ratio) : "\u2013")});
  }
  return html + html_table(table);
}

Html left_out_section(const SceneStudy& study) {
  Html items;
  for (const LeftOut& left : study.left_out)
    items += html_line("li", fmt::format("{}: {}", left.what, left.why));
  int below = 0;
  for (const StudyPoint& point : study.points)
    below += point.is_shown() ? 0 : 1;
  if (below > 0) {
    items += html_line(
        "li", fmt::format("{} point{} on the charts: {} less than {} times above the "
                          "reference's own error; the table says \u201c<\u201d.",
                          below, below == 1 ? "" : "s",
                          below == 1 ? "its error is" : "their errors are", kReferenceMargin));
  }
  if (items.code.empty()) return {};
  return html_line("h2", "What was left out, and why") + html_element("ul", items);
}

Html method_section(const SceneStudy& study) {
  const RenderSettings& r = study.reference;
  Html html = html_line("h2", "How it was measured");
  html += html_line(
      "p", fmt::format("The converged picture is the mean of two halves with seeds of their own, "
                       "{} samples a pixel in all, depth {}, cutoff {}, filter {}. By the halves' "
                       "difference its sampling error is {} (RMSE); by the last step of depth and "
                       "cutoff its truncation error is {}. No error below {} is shown: ten times "
                       "both together.{}",
                       r.samples, r.max_depth, print_number(r.cutoff), setting_name(r.filter.kind),
                       print_number(study.sampling_error), print_number(study.truncation_error),
                       print_number(study.floor()), filters_text(study)));
  html += html_line(
      "p", fmt::format("Times are medians of {} runs, in turn: every setting once, then every "
                       "setting again. They are of rendering alone, the scene read and nothing "
                       "written. Errors are of linear light in the working space. The study took "
                       "{} of {}.",
                       study.runs, duration_text(study.seconds), duration_text(study.budget)));
  return html;
}

}  // namespace alhazen
