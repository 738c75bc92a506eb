#include "app/study/report_page.h"

#include <fmt/format.h>

#include "app/page/base64.h"
#include "app/page/page.h"
#include "app/page/table.h"
#include "app/study/conclusions.h"
#include "app/study/number_text.h"
#include "app/study/page_look.h"
#include "app/study/report_sections.h"
#include "app/study/study_charts.h"
#include "render/image/png_write.h"

namespace alhazen {
namespace {

Html list_of(const std::vector<std::string>& sentences, const char* css_class) {
  Html items;
  for (const std::string& sentence : sentences)
    items += html_line("li", sentence);
  return html_element("ul", items, {{"class", css_class}});
}

Html legend_of(const Chart& chart, bool with_scene) {
  Html items;
  for (const ChartSeries& series : chart.series)
    items += html_element("li", legend_marker(series) + html_line("span", series.name));
  items +=
      html_element("li", html_element("span", {}, {{"class", "swatch"}}) +
                             html_line("span", "Pareto front: nothing is both faster and better"));
  if (with_scene) {
    items += html_element("li", html_element("span", {}, {{"class", "ring"}}) +
                                    html_line("span", "the scene's own settings"));
  }
  return html_element("ul", items, {{"class", "legend"}});
}

Html main_section(const SceneStudy& study) {
  const Chart wide = main_chart(study, false), narrow = main_chart(study, true);
  return html_element("div", chart_svg(wide), {{"class", "chart wide-chart"}}) +
         html_element("div", chart_svg(narrow), {{"class", "chart narrow"}}) +
         legend_of(wide, study.scene_point().is_shown()) +
         html_line("p",
                   "Rest on a point, or tap it, for its pictures. Broken lines are the slopes that "
                   "theory expects; both axes are logarithmic.",
                   {{"class", "quiet"}});
}

Html knob_section(const SceneStudy& study) {
  Html parts;
  for (const KnobChart& knob : knob_charts(study)) {
    parts += html_element("section",
                          html_line("h3", knob.heading) + html_line("p", knob.remark) +
                              html_element("div", chart_svg(knob.chart), {{"class", "chart"}}));
  }
  return html_line("h2", "One knob at a time") + html_element("div", parts, {{"class", "knobs"}});
}

Result<Html> image(const std::vector<std::uint8_t>& rgb, const StudyPictures& pictures,
                   const std::string& alt) {
  const Result<std::string> png = render::encode_png(rgb, pictures.width, pictures.height, 3);
  if (!png) return png.error();
  return Html{
      fmt::format("<img src=\"data:image/png;base64,{}\" alt=\"{}\" width=\"{}\" "
                  "height=\"{}\" loading=\"lazy\">",
                  base64(png.value()), html_text(alt).code, pictures.width, pictures.height)};
}

Result<Html> figure(const SceneStudy& study, const StudyPoint& point, const std::string& id) {
  const std::string text = setting_text(study, point);
  const Result<Html> shown = image(point.pictures.shown, point.pictures, text);
  if (!shown) return shown.error();
  const Result<Html> error = image(point.pictures.error, point.pictures, "its error");
  if (!error) return error.error();
  const Html pair = html_element("div", shown.value() + error.value(), {{"class", "pair"}});
  const std::string figures = fmt::format(
      "RMSE {}{}, largest {}, {} over 1/255, FLIP {}; {} CPU", point.is_shown() ? "" : "under ",
      print_number(point.is_shown() ? point.errors.rmse : point.floor),
      print_number(point.errors.largest), percent_text(point.errors.share_over()),
      print_number(point.errors.flip), duration_text(point.cpu.median));
  return html_element(
      "figure",
      pair + html_element("figcaption", html_line("b", text) + html_line("span", figures)),
      {{"id", id}});
}

Result<Html> picture_section(const SceneStudy& study) {
  const std::vector<std::string> ids = picture_ids(study);
  Html figures;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    if (ids[i] != fmt::format("p{}", i)) continue;
    const Result<Html> html = figure(study, study.points[i], ids[i]);
    if (!html) return html.error();
    figures += html.value();
  }
  return html_line("h2", "Every point") +
         html_line("p",
                   "Left what was rendered, right where it errs, by the largest channel: black up "
                   "to 1/1024, pale yellow from 1/4 on, on a scale of logarithms.") +
         html_element("div", figures, {{"class", "points"}});
}

}  // namespace

Result<std::string> study_page(const SceneStudy& study) {
  const Result<Html> pictures = picture_section(study);
  if (!pictures) return pictures.error();
  Html body = html_line("p", size_text(study), {{"class", "quiet"}});
  body += list_of(conclusions(study), "lead");
  body += main_section(study);
  body += knob_section(study);
  body += rounding_section(study) + povray_section(study);
  body += html_line("h2", "All figures") + points_table(study);
  body += pictures.value();
  body += left_out_section(study) + method_section(study);
  return html_page("What accuracy costs: " + study.name, body, study_page_extras());
}

}  // namespace alhazen
