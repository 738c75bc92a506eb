// render/wave: the one decision of what runs. A StagePlan is computed once from what the scene
// calls for; the integrator runs its stages and nothing else, and no stage asks again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/effect.h"

namespace alhazen::render {

enum class Phase { start, generation, round };

enum class StageId {
#define ALHAZEN_STAGE(name, ...) name,
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
#define ALHAZEN_STAGE(name, phase, file, text, keeps, ...) {#name, Phase::phase, text, keeps},
#include "render/wave/stage.def"
#undef ALHAZEN_STAGE
};
inline constexpr std::size_t kStageCount = std::size(kStageInfo);
constexpr const StageInfo& info(StageId stage) {
  return kStageInfo[static_cast<std::size_t>(stage)];
}

// Whether `has(effect)` is true of what the stage is for.
template <class Has>
constexpr bool is_called(StageId stage, const Has& has) {
  using enum Effect;
  switch (stage) {
#define ALHAZEN_STAGE(name, phase, file, text, keeps, effects, ...) \
  case StageId::name:                                               \
    return effects;
#include "render/wave/stage.def"
#undef ALHAZEN_STAGE
  }
  return false;
}

// Whether the stage sends rays on from what rays have met.
constexpr bool sends_rays_on(StageId stage) {
  using enum StageId;
  switch (stage) {
    case mirror:
    case metal:
    case coat:
    case glass:
    case pov_reflection:
    case pov_transmission:
      return true;
    default:
      return false;
  }
}

struct PlannedStage {
  StageId id;
  std::vector<Effect> because;  // empty: every picture needs it
  std::vector<Effect> serves;   // effects that have part of their work done here

  friend bool operator==(const PlannedStage&, const PlannedStage&) = default;
};

// Stages in the order of stage.def; two plans are equal if they run the same for the same reasons.
struct StagePlan {
  std::vector<PlannedStage> start, generation, round;

  bool runs(StageId id) const;
  // Calls visit(stage) with all of them.
  template <class Visitor>
  void for_each(const Visitor& visit) const {
    for (const auto* phase : {&start, &generation, &round}) {
      for (const PlannedStage& stage : *phase)
        visit(stage);
    }
  }
  friend bool operator==(const StagePlan&, const StagePlan&) = default;
};

// What data channels ask for that the picture itself would not.
struct PlanWants {
  bool albedo = false;  // the colours of surfaces that no light and no ray asks for
  bool signature = false, margin = false;
};

// What the scene calls for, with what only the geometry can tell: whether a point that camera rays
// start from may lie inside of something clear.
EffectSet effects_of(const Scene& scene, const PlanWants& wants = {});

// Error unsupported, naming it, if one of them is of those that a build was made without;
// `left_out` as ALHAZEN_LEAVE_OUT, with commas.
Status check_built_in(const EffectSet& effects, std::string_view left_out);
// By what this build was made without.
Status check_built_in(const EffectSet& effects);

StagePlan make_plan(const Scene& scene, const EffectSet& effects, const PlanWants& wants = {});

}  // namespace alhazen::render
