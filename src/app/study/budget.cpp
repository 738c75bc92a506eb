#include "app/study/budget.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <numeric>

#include "app/study/number_text.h"

namespace alhazen {
namespace {

// One entry for each knob, with the labels of its settings.
std::vector<LeftOut> by_knob(std::span<const StudySetting> settings,
                             const std::function<std::string(const std::vector<std::size_t>&)>& why,
                             const std::vector<bool>& kept) {
  std::vector<LeftOut> out;
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    std::string labels;
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < settings.size(); ++i) {
      if (kept[i] || settings[i].knob != static_cast<Knob>(k)) continue;
      labels += fmt::format("{}{}", labels.empty() ? "" : ", ", settings[i].label);
      members.push_back(i);
    }
    if (members.empty()) continue;
    out.push_back({fmt::format("{}: {}", kKnobInfo[k].title, labels), why(members)});
  }
  return out;
}

std::vector<StudySetting> those_kept(std::span<const StudySetting> settings,
                                     const std::vector<bool>& kept) {
  std::vector<StudySetting> out;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (kept[i]) out.push_back(settings[i]);
  }
  return out;
}

double average_samples(const RenderSettings& settings) {
  // Guesses, both: 64 samples for 1/255, and in proportion.
  if (settings.max_error) return 0.25 / settings.max_error->error;
  if (!settings.adaptive) return settings.samples;
  // A guess: twice as many for half the threshold, from the minimum at 0.1 on.
  const AdaptiveSampling& adaptive = *settings.adaptive;
  return std::clamp(adaptive.min_samples * 0.1 / adaptive.threshold, 1.0 * adaptive.min_samples,
                    1.0 * settings.samples);
}

}  // namespace

TimeShares time_shares(bool with_povray) {
  TimeShares shares;
  if (!with_povray) return shares;
  shares.povray = 0.4;
  for (double* share : {&shares.references, &shares.rounding, &shares.sweep})
    *share *= 1 - shares.povray;
  return shares;
}

double predicted_seconds(const StudySetting& setting, const PilotCost& cost) {
  double factor = average_samples(setting.settings);
  if (setting.precision == render::Precision::quad) factor *= kQuadFactor;
  if (setting.light_samples) {
    const double as_many =
        static_cast<double>(*setting.light_samples) / std::max(1, cost.scene_light_samples);
    factor *= 1 - cost.shadow_share + cost.shadow_share * as_many;
  }
  return cost.fixed_seconds + factor * cost.seconds_a_sample;
}

BudgetChoice choose_for_budget(std::span<const StudySetting> settings, const PilotCost& cost,
                               int runs, double seconds) {
  std::vector<double> predicted;
  for (const StudySetting& setting : settings)
    predicted.push_back(runs * predicted_seconds(setting, cost));
  std::vector<std::size_t> order(settings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (settings[a].is_scene != settings[b].is_scene) return settings[a].is_scene;
    if (settings[a].rank != settings[b].rank) return settings[a].rank < settings[b].rank;
    return predicted[a] < predicted[b];
  });
  BudgetChoice choice;
  std::vector<bool> kept(settings.size());
  for (const std::size_t i : order) {
    if (!settings[i].is_scene && choice.seconds + predicted[i] > seconds) continue;
    kept[i] = true;
    choice.seconds += predicted[i];
  }
  choice.kept = those_kept(settings, kept);
  const auto why = [&](const std::vector<std::size_t>& members) {
    double more = 0;
    for (const std::size_t i : members)
      more += predicted[i];
    return fmt::format("the time does not suffice: about {} more", duration_text(more));
  };
  choice.left_out = by_knob(settings, why, kept);
  return choice;
}

BudgetChoice within_reference(std::span<const StudySetting> settings, int reference_samples) {
  std::vector<bool> kept;
  for (const StudySetting& setting : settings) {
    const RenderSettings& s = setting.settings;
    kept.push_back(setting.is_scene || s.adaptive || s.max_error ||
                   kReferenceSamplesATime * s.samples <= reference_samples);
  }
  const auto why = [&](const std::vector<std::size_t>&) {
    return fmt::format("too near to the reference's {} samples to be measured against it",
                       reference_samples);
  };
  return {those_kept(settings, kept), by_knob(settings, why, kept), 0};
}

}  // namespace alhazen
