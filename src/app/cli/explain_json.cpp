#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/explain_plan.h"
#include "core/scene/this_build.h"

namespace alhazen {
namespace {

using Json = nlohmann::ordered_json;
using render::PlannedStage;

Json names_of(const std::vector<Effect>& effects) {
  Json names = Json::array();
  for (const Effect effect : effects)
    names.push_back(info(effect).name);
  return names;
}

// The stages whose `list` names the effect.
Json stages_of(const ExplainedPlan& explained, Effect effect,
               std::vector<Effect> PlannedStage::*list) {
  Json names = Json::array();
  explained.plan.for_each([&](const PlannedStage& stage) {
    const std::vector<Effect>& effects = stage.*list;
    if (std::find(effects.begin(), effects.end(), effect) == effects.end()) return;
    names.push_back(render::info(stage.id).name);
  });
  return names;
}

Json effect_json(const ExplainedPlan& explained, Effect effect) {
  Json lines = Json::array();
  for (const SourceSpan span : explained.effects.callers(effect))
    lines.push_back(explained.sources.describe(span));
  return {{"name", info(effect).name},
          {"text", info(effect).text},
          {"called", explained.effects.has(effect)},
          {"built_in", is_built_in(effect)},
          {"lines", std::move(lines)},
          {"starts", stages_of(explained, effect, &PlannedStage::because)},
          {"works_in", stages_of(explained, effect, &PlannedStage::serves)}};
}

Json stage_json(const ExplainedPlan& explained, const PlannedStage& stage) {
  static constexpr const char* kPhases[] = {"start", "generation", "round"};
  const render::StageInfo& about = render::info(stage.id);
  Json json = {{"name", about.name},
               {"text", about.text},
               {"phase", kPhases[static_cast<std::size_t>(about.phase)]},
               {"because", names_of(stage.because)},
               {"serves", names_of(stage.serves)},
               {"keeps", about.keeps}};
  const render::StageCost* cost =
      explained.costs != nullptr ? explained.costs->of(stage.id) : nullptr;
  if (cost != nullptr) {
    json["rays"] = cost->rays;
    json["cpu_seconds"] = cost->cpu_seconds;
  }
  return json;
}

}  // namespace

std::string explain_json(const ExplainedPlan& explained) {
  Json out = {{"effects", Json::array()}, {"stages", Json::array()}};
  for (std::size_t i = 0; i < kEffectCount; ++i)
    out["effects"].push_back(effect_json(explained, static_cast<Effect>(i)));
  explained.plan.for_each(
      [&](const PlannedStage& stage) { out["stages"].push_back(stage_json(explained, stage)); });
  if (explained.costs != nullptr) out["cpu_seconds"] = explained.costs->cpu_seconds;
  return out.dump(2) + "\n";
}

}  // namespace alhazen
