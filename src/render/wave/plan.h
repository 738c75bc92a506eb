// render/wave: the one decision of what runs. A StagePlan is computed once from what the scene
// calls for; the integrator runs its stages and nothing else, and no stage asks again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/effect.h"

namespace alhazen::render {

enum class Phase { start, generation };

enum class StageId {
#define ALHAZEN_STAGE(name, phase, text, keeps) name,
#include "render/wave/stage.def"
#undef ALHAZEN_STAGE
};

struct StageInfo {
  std::string_view name;
  Phase phase;
  std::string_view text;   // in English, for explain and for statistics
  std::string_view keeps;  // the buffers that exist because of it
};
inline constexpr StageInfo kStageInfo[] = {
#define ALHAZEN_STAGE(name, phase, text, keeps) {#name, Phase::phase, text, keeps},
#include "render/wave/stage.def"
#undef ALHAZEN_STAGE
};
inline constexpr std::size_t kStageCount = std::size(kStageInfo);
constexpr const StageInfo& info(StageId stage) {
  return kStageInfo[static_cast<std::size_t>(stage)];
}

struct PlannedStage {
  StageId id;
  std::vector<Effect> because;  // empty: every picture needs it
};

// Stages in the order of stage.def.
struct StagePlan {
  std::vector<PlannedStage> start, generation;

  bool runs(StageId id) const;
  friend bool operator==(const StagePlan& a, const StagePlan& b);
};

// What the scene calls for, with what only the geometry can tell: whether a point that camera rays
// start from may lie inside of something clear.
EffectSet effects_of(const Scene& scene);

// What data channels ask for that the picture itself would not.
struct PlanWants {
  bool albedo = false;  // the colours of surfaces that no light and no ray asks for
  bool signature = false, margin = false;
};
StagePlan make_plan(const Scene& scene, const EffectSet& effects, const PlanWants& wants = {});

// One line a stage with its reasons; `sources` gives the lines of the scene. The JSON has the same:
// {"effects": [{name, text, called, lines}], "stages": [{name, text, phase, because, keeps}]}.
std::string explain_text(const StagePlan& plan, const EffectSet& effects,
                         const SourceManager& sources);
std::string explain_json(const StagePlan& plan, const EffectSet& effects,
                         const SourceManager& sources);

}  // namespace alhazen::render
