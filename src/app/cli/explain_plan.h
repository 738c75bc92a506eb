// app/cli: the effects that a scene calls for and the stages that they start, for people and for
// programs.
#pragma once

#include <string>

#include "app/cli/stage_costs.h"
#include "core/diag/source.h"
#include "render/wave/plan.h"

namespace alhazen {

struct ExplainedPlan {
  const EffectSet& effects;
  const render::StagePlan& plan;
  const SourceManager& sources;  // of the scene's lines
  const StageCosts* costs = nullptr;
};

// Error usage if the figures lack a stage of the plan: they are of another scene or other settings.
Status check_costs(const render::StagePlan& plan, const StageCosts& costs, const std::string& name);

// Each effect with its lines and stages, those that nothing calls for with what would; then each
// stage in order with its reasons, or with its costs.
std::string explain_text(const ExplainedPlan& explained);

// {"effects": [{name, text, called, built_in, lines, starts, works_in}],
//  "stages": [{name, text, phase, because, serves, keeps, rays?, cpu_seconds?}], "cpu_seconds"?}
std::string explain_json(const ExplainedPlan& explained);

}  // namespace alhazen
