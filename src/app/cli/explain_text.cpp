#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "app/cli/explain_plan.h"
#include "core/scene/this_build.h"

namespace alhazen {
namespace {

using render::PlannedStage;

constexpr std::size_t kMaxShownLines = 4;

class Explainer {
 public:
  explicit Explainer(const ExplainedPlan& explained) : explained_(explained) {}

  std::string text() {
    put_called();
    put_not_called();
    if (explained_.costs != nullptr) {
      put_costs();
    } else {
      put_stages("for each batch of camera samples", explained_.plan.start);
      put_stages("for each generation of rays", explained_.plan.generation);
      put_stages("when a tile has all its samples", explained_.plan.round);
    }
    return std::move(out_);
  }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  template <class Visitor>
  static void for_each_effect(const Visitor& visit) {
    for (std::size_t i = 0; i < kEffectCount; ++i)
      visit(static_cast<Effect>(i));
  }

  void put_called() {
    put("Effects that the scene calls for: the lines that do, the stages that they start\n");
    for_each_effect([&](Effect effect) {
      if (!explained_.effects.has(effect)) return;
      put("  {:<24}{}\n", info(effect).text, lines_of(effect));
      if (!is_built_in(effect)) put("      this build leaves it out and cannot render the scene\n");
      explained_.plan.for_each([&](const PlannedStage& stage) { put_share(effect, stage); });
    });
  }

  // What the stage has to do with the effect, if anything.
  void put_share(Effect effect, const PlannedStage& stage) {
    const auto holds = [&](const std::vector<Effect>& list) {
      return std::find(list.begin(), list.end(), effect) != list.end();
    };
    const std::string_view verb = holds(stage.because)  ? "starts"
                                  : holds(stage.serves) ? "works in"
                                                        : "";
    if (verb.empty()) return;
    const std::string_view keeps = render::info(stage.id).keeps;
    put("      {}: {}{}{}\n", verb, render::info(stage.id).text, keeps.empty() ? "" : "; keeps ",
        keeps);
  }

  void put_not_called() {
    put("\nEffects that nothing calls for, which start no stage and keep no buffer\n");
    for_each_effect([&](Effect effect) {
      if (explained_.effects.has(effect)) return;
      put("  {:<24}would need {}{}\n", info(effect).text, info(effect).cause,
          is_built_in(effect) ? "" : "; left out of this build");
    });
  }

  void put_stages(std::string_view when, const std::vector<PlannedStage>& stages) {
    if (stages.empty()) return;
    put("\nStages {}\n", when);
    for (const PlannedStage& stage : stages)
      put("  {:<20}{:<54}  {}\n", render::info(stage.id).name, render::info(stage.id).text,
          reasons(stage));
  }

  void put_costs() {
    const StageCosts& costs = *explained_.costs;
    put("\n{:<22}{}  because of\n", "Stages", stage_cost_heading());
    for (const render::StageCost& cost : costs.stages) {
      std::string because = "the options of that render";
      explained_.plan.for_each([&](const PlannedStage& stage) {
        if (stage.id == cost.stage) because = reasons(stage);
      });
      put("  {:<20}{}  {}\n", render::info(cost.stage).name,
          stage_cost_row(cost, costs.cpu_seconds), because);
    }
    put("  {:<20}{}  tiles and sums of samples\n", "everything else", other_cost_row(costs));
  }

  std::string lines_of(Effect effect) const {
    const std::vector<SourceSpan>& spans = explained_.effects.callers(effect);
    if (spans.empty()) return "(settings)";
    std::string out;
    for (std::size_t i = 0; i < spans.size() && i < kMaxShownLines; ++i)
      out += (i == 0 ? "" : ", ") + explained_.sources.describe(spans[i]);
    if (spans.size() > kMaxShownLines) {
      out += fmt::format(" and {} more", spans.size() - kMaxShownLines);
    }
    return out;
  }

  static std::string reasons(const PlannedStage& stage) {
    std::string out;
    for (const Effect effect : stage.because)
      out += (out.empty() ? "" : ", ") + std::string(info(effect).text);
    return out.empty() ? "every picture of this kind" : out;
  }

  const ExplainedPlan& explained_;
  std::string out_;
};

}  // namespace

Status check_costs(const render::StagePlan& plan, const StageCosts& costs,
                   const std::string& name) {
  Status status = Unit{};
  plan.for_each([&](const PlannedStage& stage) {
    if (!status || costs.of(stage.id) != nullptr) return;
    status = Error{ErrorCode::usage,
                   fmt::format("{} has no figures of the stage `{}`, which this scene runs: it is "
                               "of another scene, or was rendered with other options",
                               name, render::info(stage.id).name)};
  });
  return status;
}

std::string explain_text(const ExplainedPlan& explained) {
  return Explainer(explained).text();
}

}  // namespace alhazen
