// render/wave: from the names of stages to the functions that are the stages.
#pragma once

#include <vector>

#include "render/wave/stage_camera.h"
#include "render/wave/stage_decisions.h"
#include "render/wave/stage_glass.h"
#include "render/wave/stage_hits.h"
#include "render/wave/stage_light.h"
#include "render/wave/stage_pov.h"
#include "render/wave/stage_reflect.h"
#include "render/wave/stage_shadow.h"

namespace alhazen::render {

template <class Real>
struct StageCall {
  using Function = void (*)(Wave<Real>&);
  StageId id;
  Function function;
};

// Null for a stage that this build leaves out, whose code is not even instantiated.
template <class Real>
typename StageCall<Real>::Function stage_function(StageId id) {
  switch (id) {
#define ALHAZEN_STAGE(name, phase, text, keeps, effects, ...)     \
  case StageId::name:                                             \
    if constexpr (is_built_in(StageId::name)) return __VA_ARGS__; \
    break;
#include "render/wave/stage.def"
#undef ALHAZEN_STAGE
  }
  return nullptr;
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
