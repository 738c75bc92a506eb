// app/povray: which transparent solids may overlap: POV-Ray treats those differently.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace alhazen {

// The places of the solids of glass, or of `pov_finish` that reflects by Fresnel and lets light
// through, whose boxes along the world's axes overlap that of another such solid of another
// material.
std::vector<SourceSpan> solids_within_solids(const Scene& scene);

}  // namespace alhazen
