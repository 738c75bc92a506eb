// render/wave: from the names of stages to the functions that are the stages.
#pragma once

#include <utility>
#include <vector>

#include "render/wave/stages.h"

namespace alhazen::render {

template <class Real>
struct StageCall {
  StageId id;
  StageFunction<Real> function;
};

// Null for a stage that this build leaves out, and for those that are no loops over rays.
template <class Real>
StageFunction<Real> stage_function(StageId id) {
  StageFunction<Real> found = nullptr;
  const auto ask = [&]<std::size_t... k>(std::index_sequence<k...>) {
    const auto keep = [&](StageFunction<Real> function) {
      if (function != nullptr) found = function;
    };
    (keep(StagesOf<static_cast<StageHome>(k)>::function(id, Real())), ...);
  };
  ask(std::make_index_sequence<static_cast<std::size_t>(StageHome::none)>());
  return found;
}

template <class Real>
std::vector<StageCall<Real>> stage_functions(const std::vector<PlannedStage>& planned) {
  std::vector<StageCall<Real>> calls;
  for (const PlannedStage& stage : planned) {
    calls.push_back({stage.id, stage_function<Real>(stage.id)});
  }
  return calls;
}

}  // namespace alhazen::render
