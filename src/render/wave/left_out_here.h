// render/wave: what of a stage's file is compiled. ALHAZEN_LEFT_OUT_HERE are those effects of
// ALHAZEN_LEAVE_OUT that the file has something of (tell_what_is_left_out.cmake): other files are
// the same with and without them, and a compiler cache need not compile those again.
#pragma once

#include "core/scene/left_out.h"
#include "render/wave/plan.h"

namespace alhazen::render {
namespace {  // each file has its own list

constexpr bool is_built_here(Effect effect) {
  return !is_left_out(effect, ALHAZEN_LEFT_OUT_HERE);
}

constexpr bool is_built_here(StageId stage) {
  return is_called(stage, [](Effect effect) { return is_built_here(effect); });
}

}  // namespace
}  // namespace alhazen::render
