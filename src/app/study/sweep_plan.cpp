#include "app/study/sweep_plan.h"

#include <algorithm>
#include <fmt/format.h>

#include "render/film/filter.h"

namespace alhazen {
namespace {

constexpr int kSampleCounts[] = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
constexpr double kThresholds[] = {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
// What --preset calls draft, normal and final.
constexpr double kTargets[] = {1.0 / 64, 1.0 / 255, 1.0 / 1024};
constexpr int kDepths[] = {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64};
constexpr double kCutoffs[] = {0.1,       1.0 / 32,   1.0 / 64,   1.0 / 128,  1.0 / 256,
                               1.0 / 512, 1.0 / 1024, 1.0 / 4096, 1.0 / 65536};
constexpr int kLightSamples[] = {1, 2, 4, 8, 16};
constexpr FilterKind kFilters[] = {FilterKind::box, FilterKind::tent, FilterKind::gaussian,
                                   FilterKind::mitchell};
constexpr int kFewSamples[] = {4, 16, 64};

// Effects by which a ray has children.
constexpr Effect kBranching[] = {Effect::mirror,         Effect::metal,
                                 Effect::coat,           Effect::refraction,
                                 Effect::pov_reflection, Effect::pov_transmission};

bool branches(const EffectSet& effects) {
  return std::ranges::any_of(kBranching, [&](Effect effect) { return effects.has(effect); });
}

class SweepPlanner {
 public:
  SweepPlanner(const Scene& scene, const EffectSet& effects) : effects_(effects) {
    base_.settings = scene.settings;
  }

  SweepPlan plan() {
    sweep_samples();
    sweep_adaptive();
    sweep_targets();
    if (asks_for(Knob::light_samples)) sweep_light_samples();
    if (asks_for(Knob::depth)) sweep_depth();
    if (asks_for(Knob::cutoff)) sweep_cutoff();
    sweep_filters();
    sweep_precision();
    combine();
    mark_scene();
    return std::move(plan_);
  }

 private:
  bool asks_for(Knob knob) {
    if (is_called_for(knob, effects_)) return true;
    const std::string why = knob == Knob::light_samples
                                ? "no light with a face casts shadows"
                                : "no mirror, metal, coat or glass: no ray has children";
    plan_.left_out.push_back({std::string(info(knob).title), why});
    return false;
  }

  // The scene's settings with a fixed number of samples.
  StudySetting with_samples(Knob knob, int samples) const {
    StudySetting setting = base_;
    setting.knob = knob;
    setting.settings.samples = samples;
    setting.settings.adaptive.reset();
    setting.settings.max_error.reset();
    return setting;
  }
  StudySetting for_comparing(Knob knob) const {
    return with_samples(knob, comparing_samples(base_.settings));
  }

  void add(StudySetting setting, std::string label, int rank) {
    setting.label = std::move(label);
    setting.rank = rank;
    const auto same = [&](const StudySetting& other) { return is_same(setting, other); };
    // A point on two curves: each curve has it, but it is rendered once (see study.cpp).
    const auto on_this_curve = [&](const StudySetting& other) {
      return same(other) && other.knob == setting.knob;
    };
    if (std::ranges::none_of(plan_.settings, on_this_curve)) {
      plan_.settings.push_back(std::move(setting));
    }
  }

  void sweep_samples() {
    for (const int samples : kSampleCounts) {
      add(with_samples(Knob::samples, samples), fmt::format("{}", samples), samples <= 64 ? 0 : 5);
    }
  }

  void sweep_adaptive() {
    for (const double threshold : kThresholds) {
      StudySetting setting = base_;
      setting.knob = Knob::adaptive;
      setting.settings.samples = kAdaptiveSamples;
      setting.settings.max_error.reset();
      setting.settings.adaptive = AdaptiveSampling{};
      setting.settings.adaptive->threshold = threshold;
      if (base_.settings.adaptive) {
        setting.settings.adaptive->min_samples = base_.settings.adaptive->min_samples;
      }
      add(setting, fmt::format("t {:g}", threshold), threshold >= 0.01 ? 1 : 4);
    }
  }

  void sweep_targets() {
    for (const double target : kTargets) {
      StudySetting setting = with_samples(Knob::target, base_.settings.samples);
      setting.settings.max_error = ErrorTarget{target, 0};
      add(setting, cutoff_text(target), target > 0.001 ? 1 : 4);
    }
  }

  void sweep_light_samples() {
    for (const int count : kLightSamples) {
      StudySetting setting = for_comparing(Knob::light_samples);
      setting.light_samples = count;
      add(setting, fmt::format("{}", count), 1);
    }
  }

  void sweep_depth() {
    for (const int depth : kDepths) {
      StudySetting setting = for_comparing(Knob::depth);
      setting.settings.max_depth = depth;
      add(setting, fmt::format("{}", depth), 2);
    }
  }

  void sweep_cutoff() {
    for (const double cutoff : kCutoffs) {
      StudySetting setting = for_comparing(Knob::cutoff);
      setting.settings.cutoff = cutoff;
      add(setting, cutoff_text(cutoff), 2);
    }
  }

  void sweep_filters() {
    for (const FilterKind kind : kFilters) {
      for (const int samples : kFewSamples) {
        StudySetting setting = with_samples(Knob::filter, samples);
        if (kind != base_.settings.filter.kind) {
          setting.settings.filter = {kind, render::usual_radius(kind)};
        }
        add(setting, fmt::format("{} {}", setting_name(kind), samples), 3);
      }
    }
  }

  void sweep_precision() {
    for (const int samples : kFewSamples) {
      StudySetting setting = with_samples(Knob::precision, samples);
      setting.precision = render::Precision::float32;
      add(setting, fmt::format("float {}", samples), 3);
    }
  }

  // Drafts save on everything at once; and one light sample with many camera samples spreads the
  // same shadow rays over more of the pixel.
  void combine() {
    for (const int samples : kFewSamples) {
      StudySetting setting = with_samples(Knob::combination, samples);
      if (branches(effects_)) {
        setting.settings.max_depth = 4;
        setting.settings.cutoff = 1.0 / 64;
        add(setting, fmt::format("{}, depth 4", samples), 3);
      }
      if (is_called_for(Knob::light_samples, effects_)) {
        setting = with_samples(Knob::combination, 4 * samples);
        setting.light_samples = 1;
        add(setting, fmt::format("{}, light 1", 4 * samples), 3);
        setting = with_samples(Knob::combination, samples / 4);
        setting.light_samples = 16;
        add(setting, fmt::format("{}, light 16", samples / 4), 3);
      }
    }
  }

  void mark_scene() {
    const auto own = [&](const StudySetting& setting) { return is_same(setting, base_); };
    const auto found = std::ranges::find_if(plan_.settings, own);
    if (found != plan_.settings.end()) {
      found->is_scene = true;
      found->rank = 0;
      return;
    }
    if (base_.settings.max_error) {
      base_.knob = Knob::target;
      base_.label = cutoff_text(base_.settings.max_error->error);
      base_.is_scene = true;
      plan_.settings.push_back(base_);
      return;
    }
    base_.knob = base_.settings.adaptive ? Knob::adaptive : Knob::samples;
    base_.is_scene = true;
    const auto& adaptive = base_.settings.adaptive;
    base_.label = adaptive ? fmt::format("t {:g}", adaptive->threshold)
                           : fmt::format("{}", base_.settings.samples);
    plan_.settings.push_back(base_);
  }

  const EffectSet& effects_;
  StudySetting base_;
  SweepPlan plan_;
};

}  // namespace

bool is_called_for(Knob knob, const EffectSet& effects) {
  switch (knob) {
    case Knob::light_samples:
      return effects.has(Effect::soft_shadows);
    case Knob::depth:
    case Knob::cutoff:
      return branches(effects);
    default:
      return true;
  }
}

int comparing_samples(const RenderSettings& settings) {
  return std::clamp(settings.samples, 4, 16);
}

SweepPlan plan_sweep(const Scene& scene, const EffectSet& effects) {
  return SweepPlanner(scene, effects).plan();
}

}  // namespace alhazen
