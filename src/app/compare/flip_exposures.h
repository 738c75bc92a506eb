// app/compare: the exposures at which HDR-FLIP looks, and the curve through which it does.
#pragma once

#include "render/image/pixel_buffer.h"

namespace alhazen {

// Evenly spaced, in stops.
struct FlipExposures {
  double first = 0.0, last = 0.0;
  int count = 1;

  double at(int index) const {
    return count == 1 ? first : first + (last - first) * index / (count - 1);
  }
};

// From the exposure that shows the brightest luminance of `reference` as 0.85 to the one that does
// so with the median, about one a stop and at least two. The paper says nothing of black: the
// median is that of the pixels that have light, and if none has, the exposure is 0. Never more than
// 40, which are the stops between the smallest and the largest half.
FlipExposures flip_exposures(const render::FloatBuffer& reference);

// The curve of film by Narkowicz ("ACES Filmic Tone Mapping Curve", 2015), clamped to 0 .. 1.
double film_curve(double light);

// film_curve of light times 2^exposure. Both pictures here are channels R, G, B, linear Rec.709,
// the given one not clamped.
render::FloatBuffer tone_mapped(const render::FloatBuffer& light, double exposure);

}  // namespace alhazen
