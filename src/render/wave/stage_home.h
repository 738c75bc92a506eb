// render/wave: for the files stage_*.cpp, which instantiate it: the functions of the stages that a
// file has.
#pragma once

#include "render/wave/left_out_here.h"
#include "render/wave/stages.h"

namespace alhazen::render {

template <StageHome home, class Real>
StageFunction<Real> stage_in(StageId id) {
  switch (id) {
#define ALHAZEN_STAGE(name, phase, file, text, keeps, effects, ...)                            \
  case StageId::name:                                                                          \
    if constexpr (StageHome::file == home && is_built_here(StageId::name)) return __VA_ARGS__; \
    break;
#include "render/wave/stage.def"
#undef ALHAZEN_STAGE
  }
  return nullptr;
}

template <StageHome home>
StageFunction<float> StagesOf<home>::function(StageId id, float) {
  return stage_in<home, float>(id);
}
template <StageHome home>
StageFunction<double> StagesOf<home>::function(StageId id, double) {
  return stage_in<home, double>(id);
}
#if ALHAZEN_HAS_QUAD
template <StageHome home>
StageFunction<Quad> StagesOf<home>::function(StageId id, Quad) {
  return stage_in<home, Quad>(id);
}
#endif

}  // namespace alhazen::render
