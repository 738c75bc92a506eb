// render/wave: what of a stage's file is compiled. ALHAZEN_LEFT_OUT_HERE are those effects of
// ALHAZEN_LEAVE_OUT that the file has something of (CMakeLists.txt): files that have nothing of an
// effect are the same with and without it, and a compiler cache need not compile them again.
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
