// app/povray: what is too far away or too small for POV-Ray's fixed tolerances.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace alhazen {

// Where parallel lights are put: well within POV-Ray's farthest distance, 1e7.
inline constexpr double kFarAway = 1e5;

// The places of such shapes. Planes, which are everywhere, are not among them.
std::vector<SourceSpan> shapes_out_of_reach(const Scene& scene);

}  // namespace alhazen
