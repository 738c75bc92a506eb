// app/compare: FLIP of pictures that hold more light than a display shows: Andersson, Nilsson,
// Shirley and Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range Images", 2021.
#pragma once

#include "app/compare/flip.h"
#include "app/compare/flip_exposures.h"

namespace alhazen {

struct HdrFlipResult {
  FlipResult flip;  // the largest error of each pixel at any of the exposures
  FlipExposures exposures;
};

// Channels R, G, B: linear Rec.709, not clamped. The exposures are those of `b`, the reference.
// Preconditions as for flip(). Takes the time of flip() for each exposure.
HdrFlipResult hdr_flip(const render::FloatBuffer& a, const render::FloatBuffer& b,
                       double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace alhazen
