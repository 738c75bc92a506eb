// app/study: what a terminal shows.
#include <fmt/format.h>

#include "app/study/conclusions.h"
#include "app/study/number_text.h"
#include "app/study/report_data.h"
#include "app/study/report_sections.h"
#include "app/study/study_charts.h"

namespace alhazen {
namespace {

constexpr std::size_t kColumns = 100;

// Broken at blanks, each line after the first indented like the first.
std::string wrapped(const std::string& text, const std::string& first, const std::string& rest) {
  std::string out, line = first;
  std::size_t width = first.size();
  bool begun = false;  // the line has a word
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (width + 1 + word.size() > kColumns && begun) {
      out += line + "\n";
      line = rest;
      width = rest.size();
      begun = false;
    }
    if (begun) line += ' ', ++width;
    begun = true;
    line += word;
    width += word.size();
    begin = end + 1;
  }
  return out + line + "\n";
}

std::string row(const SceneStudy& study, const StudyPoint& p, bool on_front) {
  return fmt::format(
      " {} {:<40} {:>9} {:>9} {:>9} {:>12} {:>8}\n", on_front ? '*' : ' ', setting_text(study, p),
      duration_text(p.cpu.median),
      (p.is_shown() ? "" : "<") + number_text(p.is_shown() ? p.errors.rmse : p.floor),
      number_text(p.errors.largest), percent_text(p.errors.share_over()),
      number_text(p.errors.flip));
}

std::string equal_text(const SceneStudy& study) {
  std::string text = fmt::format("\n  {:<12} {:>16} {:>16} {:>18}\n", "same RMSE", "Alhazen",
                                 "POV-Ray", "POV-Ray / Alhazen");
  for (const EqualError& e : equal_errors(study)) {
    const auto ratio = e.ratio();
    text += fmt::format("  {:<12} {:>16} {:>16} {:>18}\n", number_text(e.rmse), time_text(e.ours),
                        time_text(e.povray), ratio ? ratio_text(*ratio) : "-");
  }
  return text;
}

}  // namespace

std::string study_table(const SceneStudy& study) {
  std::string text = wrapped(fmt::format("{}: {}", study.name, size_text(study)), "", "  ");
  for (const std::string& sentence : conclusions(study))
    text += wrapped(sentence, "  ", "  ");
  text += fmt::format("\n   {:<40} {:>9} {:>9} {:>9} {:>12} {:>8}\n",
                      "settings (* on the Pareto front)", "CPU", "RMSE", "largest", "over 1/255",
                      "FLIP");
  for (const bool povray : {false, true}) {
    const std::vector<std::size_t> front = front_of(study, povray);
    for (std::size_t i = 0; i < study.points.size(); ++i) {
      if (study.points[i].is_povray() != povray) continue;
      text += row(study, study.points[i], std::ranges::find(front, i) != front.end());
    }
  }
  if (study.povray && study.povray->failure.empty()) text += equal_text(study);
  if (!study.left_out.empty()) text += "\n  left out:\n";
  for (const LeftOut& left : study.left_out)
    text += wrapped(fmt::format("{}: {}", left.what, left.why), "    ", "      ");
  return text;
}

}  // namespace alhazen
