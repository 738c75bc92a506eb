// app/study: which settings a scene is studied with.
#pragma once

#include <string>
#include <vector>

#include "app/study/setting.h"
#include "core/scene/effect.h"

namespace alhazen {

// Something that was not studied, or not shown, and why: "light samples", "no effect of ...".
struct LeftOut {
  std::string what, why;
};

struct SweepPlan {
  std::vector<StudySetting> settings;  // no two the same; the scene's own is among them
  std::vector<LeftOut> left_out;
};

// What in the scene calls for the knob; the first of its effects that the scene has. Nothing when
// no effect does: then turning it changes no pixel.
bool is_called_for(Knob knob, const EffectSet& effects);

// One knob at a time from the scene's own settings, and combinations. `effects` are those of the
// scene.
SweepPlan plan_sweep(const Scene& scene, const EffectSet& effects);

// The samples at which knobs other than the samples are compared: the scene's, at most 16, so that
// a sweep of many points stays in bounds.
int comparing_samples(const RenderSettings& settings);

}  // namespace alhazen
