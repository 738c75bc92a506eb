#include "app/study/conclusions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/study/guides.h"
#include "app/study/number_text.h"

namespace alhazen {
namespace {

std::string cpu_text(const StudyPoint& point) {
  return duration_text(point.cpu.median);
}

// The quickest of our points for which `good` holds.
template <class Good>
const StudyPoint* quickest(const SceneStudy& study, const Good& good) {
  const StudyPoint* best = nullptr;
  for (const StudyPoint& point : study.points) {
    if (point.is_povray() || !is_comparable(study, point) || !good(point)) continue;
    if (best == nullptr || point.cpu.median < best->cpu.median) best = &point;
  }
  return best;
}

auto reaches(double error) {
  return [error](const StudyPoint& p) { return p.is_shown() && p.errors.rmse <= error; };
}

std::string within_sentence(const SceneStudy& study) {
  const auto everywhere = [](const StudyPoint& p) { return p.errors.pixels_over == 0; };
  const auto nearly = [](const StudyPoint& p) { return p.errors.share_over() <= 0.01; };
  std::string text;
  if (const StudyPoint* all = quickest(study, everywhere)) {
    return fmt::format("Within 1/255 everywhere from {} of CPU time ({}).", cpu_text(*all),
                       setting_text(study, *all));
  }
  const StudyPoint* nearest = nullptr;
  for (const StudyPoint& point : study.points) {
    if (point.is_povray() || !is_comparable(study, point)) continue;
    if (nearest == nullptr || point.errors.pixels_over < nearest->errors.pixels_over)
      nearest = &point;
  }
  if (nearest != nullptr) {
    text = fmt::format(
        "No setting here is within 1/255 everywhere: the nearest leaves {} of the pixels over it "
        "after {} ({}).",
        percent_text(nearest->errors.share_over()), cpu_text(*nearest),
        setting_text(study, *nearest));
  }
  if (const StudyPoint* most = quickest(study, nearly)) {
    text += fmt::format(" In 99 % of the pixels it is, from {} ({}).", cpu_text(*most),
                        setting_text(study, *most));
  }
  return text;
}

std::string scene_sentence(const SceneStudy& study) {
  const StudyPoint& own = study.scene_point();
  return fmt::format(
      "The scene's own settings ({}) take {} and give an RMSE of {}{}; {} of the pixels are over "
      "1/255.",
      describe(own.setting), cpu_text(own), own.is_shown() ? "" : "less than ",
      print_number(own.is_shown() ? own.errors.rmse : own.floor),
      percent_text(own.errors.share_over()));
}

std::string cost_sentence(const SceneStudy& study) {
  const StudyPoint& own = study.scene_point();
  if (!own.is_shown()) return "";
  std::string text;
  const StudyPoint* same = quickest(study, reaches(own.errors.rmse));
  if (same != nullptr && same->cpu.median < 0.9 * own.cpu.median) {
    text = fmt::format("The same error takes {} with {}. ", cpu_text(*same),
                       setting_text(study, *same));
  }
  const StudyPoint* half = quickest(study, reaches(own.errors.rmse / 2));
  if (half == nullptr) {
    return text + "Half of that error is reached by no setting that can be shown here.";
  }
  return text + fmt::format("Halving the error from here costs {} times the time ({}, {}).",
                            ratio_text(half->cpu.median / own.cpu.median), cpu_text(*half),
                            setting_text(study, *half));
}

std::string slope_sentence(const SceneStudy& study) {
  std::vector<CostPoint> points;
  for (const StudyPoint& p : study.points) {
    if (p.setting.knob != Knob::samples || !p.is_shown() || p.setting.settings.samples < 4)
      continue;
    points.push_back({static_cast<double>(p.setting.settings.samples), p.errors.rmse});
  }
  const auto slope = points.size() < 3 ? std::nullopt : fitted_slope(points);
  if (!slope) return "";
  return fmt::format(
      "From 4 samples on the error falls with the samples to the power of \u2212{:.2f}.", -*slope);
}

std::string truncation_sentence(const SceneStudy& study) {
  const StudyPoint& own = study.scene_point();
  const double error = std::max(own.errors.rmse, own.floor);
  const StudyPoint* depth = enough(study, Knob::depth, error);
  const StudyPoint* cutoff = enough(study, Knob::cutoff, error);
  std::string text;
  if (depth != nullptr) {
    text = fmt::format("Beside that error, a depth of {} is enough (what it leaves out is {})",
                       depth->setting.settings.max_depth, print_number(*depth->truncation_rmse));
  }
  if (cutoff != nullptr) {
    text += fmt::format(
        "{} a cutoff of {} is enough ({})", text.empty() ? "Beside that error," : ", and",
        cutoff_text(cutoff->setting.settings.cutoff), print_number(*cutoff->truncation_rmse));
  }
  return text.empty() ? "" : text + ".";
}

// What was asked for, and what came of it.
std::string target_sentence(const SceneStudy& study) {
  std::string text;
  for (const StudyPoint& p : study.points) {
    if (p.setting.knob != Knob::target) continue;
    text +=
        fmt::format("{} {} gives {}{} after {}", text.empty() ? "Asked for by --max-error," : ",",
                    p.setting.label, p.is_shown() ? "" : "less than ",
                    print_number(p.is_shown() ? p.errors.rmse : p.floor), cpu_text(p));
  }
  return text.empty() ? "" : text + ".";
}

std::string rounding_sentence(const SceneStudy& study) {
  if (!study.rounding) return "";
  const std::vector<RoundingPoint>& points = study.rounding->points;
  const double in_double = points[1].errors.rmse;
  std::string text = fmt::format(
      "Rounding is off by {} in float and {} in double", print_number(points[0].errors.rmse),
      in_double > 0 ? "by " + print_number(in_double) : std::string("not at all"));
  if (const auto gain = study.rounding->gain()) {
    text += fmt::format(", {} times less", print_number(*gain));
  }
  return text + ".";
}

std::string povray_sentence(const SceneStudy& study) {
  if (!study.povray || !study.povray->failure.empty()) return "";
  std::string text;
  for (const EqualError& equal : equal_errors(study)) {
    const auto ratio = equal.ratio();
    if (!ratio) continue;
    text += fmt::format("{} {} times as long at {}",
                        text.empty() ? "To the same RMSE POV-Ray takes" : ",", ratio_text(*ratio),
                        print_number(equal.rmse));
  }
  return text.empty() ? "" : text + ".";
}

}  // namespace

bool is_comparable(const SceneStudy& study, const StudyPoint& point) {
  return point.is_povray() || point.setting.settings.filter.kind == study.reference.filter.kind;
}

std::vector<std::size_t> front_of(const SceneStudy& study, bool povray) {
  std::vector<std::size_t> shown;
  std::vector<CostPoint> costs;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const StudyPoint& point = study.points[i];
    if (point.is_povray() != povray || !point.is_shown() || !is_comparable(study, point)) continue;
    if (!(point.cpu.median > 0)) continue;
    shown.push_back(i);
    costs.push_back(point.cost());
  }
  std::vector<std::size_t> front;
  for (const std::size_t i : pareto_front(costs))
    front.push_back(shown[i]);
  return front;
}

std::optional<double> EqualError::ratio() const {
  if (!ours || !povray || ours->at_most || povray->at_most) return std::nullopt;
  return povray->seconds / ours->seconds;
}

std::vector<EqualError> equal_errors(const SceneStudy& study) {
  std::vector<CostPoint> fronts[2];
  for (const bool povray : {false, true}) {
    for (const std::size_t i : front_of(study, povray))
      fronts[povray ? 1 : 0].push_back(study.points[i].cost());
  }
  std::vector<EqualError> rows;
  for (const double error : kEqualErrors)
    rows.push_back({error, time_at_error(fronts[0], error), time_at_error(fronts[1], error)});
  return rows;
}

std::optional<double> halving_cost(const SceneStudy& study) {
  const StudyPoint& own = study.scene_point();
  if (!own.is_shown()) return std::nullopt;
  const StudyPoint* half = quickest(study, reaches(own.errors.rmse / 2));
  if (half == nullptr) return std::nullopt;
  return half->cpu.median / own.cpu.median;
}

std::string time_text(const std::optional<TimeAtError>& time) {
  if (!time) return "not reached";
  return (time->at_most ? "at most " : "") + duration_text(time->seconds);
}

const StudyPoint* enough(const SceneStudy& study, Knob knob, double error) {
  const StudyPoint* best = nullptr;
  for (const StudyPoint& point : study.points) {
    if (point.setting.knob != knob || !point.truncation_rmse) continue;
    if (*point.truncation_rmse > error / 10) continue;
    const RenderSettings& s = point.setting.settings;
    if (best == nullptr || s.max_depth < best->setting.settings.max_depth ||
        s.cutoff > best->setting.settings.cutoff) {
      best = &point;
    }
  }
  return best;
}

std::string setting_text(const SceneStudy& study, const StudyPoint& point) {
  if (!point.is_povray()) return describe_beside(point.setting, study.scene_point().setting);
  return fmt::format("{} {}", info(point.setting.knob).title, point.setting.label);
}

std::vector<std::string> conclusions(const SceneStudy& study) {
  std::vector<std::string> sentences;
  for (const auto sentence :
       {within_sentence, scene_sentence, cost_sentence, slope_sentence, truncation_sentence,
        target_sentence, rounding_sentence, povray_sentence}) {
    std::string text = sentence(study);
    if (!text.empty()) sentences.push_back(std::move(text));
  }
  return sentences;
}

}  // namespace alhazen
