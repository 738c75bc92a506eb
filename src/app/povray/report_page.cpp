#include "app/povray/report_page.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "app/page/page.h"
#include "app/page/pictures.h"
#include "app/page/table.h"
#include "render/color/preview.h"

namespace alhazen {
namespace {

constexpr std::size_t kListedPixels = 40;

std::vector<std::uint8_t> shown(const render::FloatBuffer& picture,
                                const render::ColorTransform& view) {
  return render::preview_rgb8(view, picture.channel(0), picture.channel(1), picture.channel(2));
}

// Our picture, dark and grey, with the differing pixels by their cause.
std::vector<std::uint8_t> map_of(const Verdict& verdict, const render::FloatBuffer& ours,
                                 const std::vector<std::uint8_t>& rgb) {
  static constexpr std::uint8_t kColors[][3] = {{70, 150, 255}, {255, 210, 60}, {255, 50, 50}};
  std::vector<std::uint8_t> out(rgb.size());
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    const int gray = (rgb[i] + 2 * rgb[i + 1] + rgb[i + 2]) / 12;
    std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(i), 3, static_cast<std::uint8_t>(gray));
  }
  for (const JudgedPixel& pixel : verdict.pixels) {
    const std::size_t at =
        3 * (static_cast<std::size_t>(pixel.place.row) * static_cast<std::size_t>(ours.width()) +
             static_cast<std::size_t>(pixel.place.column));
    std::copy_n(kColors[static_cast<std::size_t>(pixel.cause)], 3,
                out.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return out;
}

std::string milliseconds(double seconds) {
  return fmt::format("{:.1f} ms", 1000 * seconds);
}

Html cell(const std::string& text) {
  return html_text(text);
}

Html result_cell(const Verdict& verdict) {
  const std::string_view name = result_name(verdict);
  return verdict.passes ? html_text(name) : html_line("strong", name);
}

// How many times as long POV-Ray traces as we render. It counts whole milliseconds, so a shorter
// time says nothing.
Html ratio_cell(const CrossCheck& check, const Witness& w) {
  constexpr double kShortest = 0.01;
  if (w.run.trace_seconds < kShortest || !(check.our_seconds > 0)) return {};
  return cell(fmt::format("{:.2f}", w.run.trace_seconds / check.our_seconds));
}

Html figures_table(const CrossCheck& check) {
  HtmlTable table;
  table.columns = {{"witness"},
                   {"result"},
                   {"channels over", true, "of all channels of all pixels"},
                   {"RMSE", true},
                   {"largest", true},
                   {"ours", true, "rendering alone"},
                   {"POV-Ray tracing", true, "as POV-Ray measures it, to 1 ms"},
                   {"ratio", true, "POV-Ray's tracing to ours; left out below 10 ms"},
                   {"POV-Ray in all", true, "the whole process"},
                   {"CPU", true, "of the whole process"}};
  for (const Witness& w : check.witnesses) {
    table.rows.push_back(
        {cell(w.name), result_cell(w.verdict),
         cell(fmt::format("{} of {}", w.verdict.over, w.verdict.channels)),
         cell(fmt::format("{:.3g}", w.verdict.rmse)),
         cell(fmt::format("{:.3g}", w.verdict.largest)), cell(milliseconds(check.our_seconds)),
         cell(milliseconds(w.run.trace_seconds)), ratio_cell(check, w),
         cell(milliseconds(w.run.wall_seconds)), cell(milliseconds(w.run.cpu_seconds))});
  }
  return html_table(table);
}

Html pixel_list(const Verdict& verdict) {
  if (verdict.pixels.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < std::min(verdict.pixels.size(), kListedPixels); ++i) {
    const JudgedPixel& p = verdict.pixels[i];
    fmt::format_to(std::back_inserter(text),
                   "({}, {}) {}: ours {:.6g} {:.6g} {:.6g}, theirs {:.6g} {:.6g} {:.6g}\n",
                   p.place.column, p.place.row, name(p.cause), p.ours.r, p.ours.g, p.ours.b,
                   p.theirs.r, p.theirs.g, p.theirs.b);
  }
  if (verdict.pixels.size() > kListedPixels) {
    text += fmt::format("and {} more\n", verdict.pixels.size() - kListedPixels);
  }
  return html_element("details",
                      html_line("summary", fmt::format("{} pixels differ", verdict.pixels.size())) +
                          html_line("pre", text));
}

Html text_of(const std::string& title, const std::string& text) {
  if (text.empty()) return {};
  return html_element("details", html_line("summary", title) + html_line("pre", text));
}

Result<Html> pictures_of(const CrossCheck& check, const Witness& witness,
                         const render::ColorTransform& view) {
  const int width = check.ours.width(), height = check.ours.height();
  const auto ours = shown(check.ours, view);
  const PagePicture row[] = {
      {width, height, ours, "Alhazen", "one ray through each pixel's centre"},
      {width, height, shown(witness.picture, view), "POV-Ray", "version 3.7, " + witness.name},
      {width, height, map_of(witness.verdict, check.ours, ours), "difference",
       "Pixels over the rounding of a half float: blue at a silhouette, yellow at another edge, "
       "red anywhere else"}};
  return html_pictures(row);
}

Result<Html> section(const CrossCheck& check, const render::ColorTransform& view) {
  Html body = html_line("h2", check.name, {{"id", check.name}});
  for (const Witness& witness : check.witnesses) {
    body += html_line("p", fmt::format("{}: {}. {}.", witness.name, result_name(witness.verdict),
                                       witness.verdict.sentence));
    Result<Html> pictures = pictures_of(check, witness, view);
    if (!pictures) return pictures.error();
    body += pictures.value();
    body += pixel_list(witness.verdict);
  }
  body += figures_table(check);
  for (const std::string& deviation : check.deviation_texts)
    body += html_line("p", "Not exact: " + deviation);
  body += text_of("the scene", check.scene_text);
  for (const Witness& witness : check.witnesses)
    body += text_of("for POV-Ray, " + witness.name, witness.text);
  return body;
}

Html summary(const std::vector<CheckOutcome>& outcomes) {
  HtmlTable table;
  table.columns = {{"scene"},
                   {"witness"},
                   {"result"},
                   {"channels over", true},
                   {"RMSE", true},
                   {"ours", true, "rendering alone"},
                   {"POV-Ray tracing", true, "as POV-Ray measures it, to 1 ms"},
                   {"ratio", true, "POV-Ray's tracing to ours; left out below 10 ms"},
                   {"POV-Ray in all", true, "the whole process"}};
  for (const CheckOutcome& outcome : outcomes) {
    const Html link = html_element("a", html_text(outcome.name), {{"href", "#" + outcome.name}});
    if (!outcome.check) {
      table.rows.push_back(
          {link, cell("FAILED: " + outcome.check.error().message), {}, {}, {}, {}, {}});
      continue;
    }
    const CrossCheck& check = outcome.check.value();
    for (const Witness& w : check.witnesses) {
      table.rows.push_back(
          {link, cell(w.name), result_cell(w.verdict), cell(fmt::format("{}", w.verdict.over)),
           cell(fmt::format("{:.2g}", w.verdict.rmse)), cell(milliseconds(check.our_seconds)),
           cell(milliseconds(w.run.trace_seconds)), ratio_cell(check, w),
           cell(milliseconds(w.run.wall_seconds))});
    }
  }
  return html_table(table);
}

}  // namespace

Result<std::string> report_page(const std::vector<CheckOutcome>& outcomes,
                                const render::ColorTransform& view) {
  const auto passed = std::ranges::count_if(
      outcomes, [](const CheckOutcome& o) { return o.check && o.check.value().passes(); });
  Html body = html_line(
      "p",
      fmt::format("{} of {} scenes are the same in Alhazen and in POV-Ray 3.7. Same: all channels "
                  "agree to the rounding of a half float. But for edges: at least 99.9 % do, "
                  "and every other pixel lies at an edge. Within its tolerance: POV-Ray cannot "
                  "say exactly what the scene says.",
                  passed, outcomes.size()));
  body += summary(outcomes);
  for (const CheckOutcome& outcome : outcomes) {
    if (!outcome.check) continue;
    Result<Html> part = section(outcome.check.value(), view);
    if (!part) return part.error();
    body += part.value();
  }
  return html_page("Cross-check against POV-Ray", body);
}

}  // namespace alhazen
