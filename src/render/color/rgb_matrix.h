// render/color: matrices between linear RGB spaces, from their chromaticities.
#pragma once

#include "core/math/chromaticities.h"

namespace alhazen::render {

// The matrix from linear RGB of `from` to linear RGB of `to`, with Bradford adaptation of the white
// (Lam 1985; the linear form of ISO 15076-1 annex E), so that white goes to white.
ColorMatrix rgb_from_rgb(const Chromaticities& to, const Chromaticities& from);

}  // namespace alhazen::render
