// app/povray: whether both programs drop the same faint rays.
#pragma once

#include <optional>

#include "core/scene/scene.h"

namespace alhazen {

// POV-Ray multiplies, along a path, the largest channels of what each surface reflects at most, or
// lets through, and drops a ray when that falls below adc_bailout; here the largest channel of the
// ray's own weight counts. Both are the same only for grey surfaces that do so alike at every
// angle, and for clear glass, for which POV-Ray takes Fresnel's reflectance at the angle, too. The
// first material of another kind, in a scene with a cutoff.
std::optional<SourceSpan> cutoff_difference(const Scene& scene);

}  // namespace alhazen
