// core/scene: the effects that this build has, for those who ask once a picture. What is compiled
// many times is told of less (render/wave/left_out_here.h), for the list differs from build to
// build.
#pragma once

#include "core/scene/left_out.h"
#include "core/scene/left_out_names.h"

namespace alhazen {

static_assert(lists_effects_only(kLeftOutNames),
              "ALHAZEN_LEAVE_OUT names something that core/scene/effect.def does not");

constexpr bool is_built_in(Effect effect) {
  return !is_left_out(effect, kLeftOutNames);
}

}  // namespace alhazen
