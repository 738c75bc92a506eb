// app/compare: FLIP, the difference that is seen when two pictures alternate on one spot:
// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", 2020. Written from the paper.
#pragma once

#include "app/compare/figures.h"
#include "core/math/vec.h"
#include "render/image/pixel_buffer.h"

namespace alhazen {

// A display 0.7 m wide of 3840 pixels, seen from 0.7 m: distance * (pixels / width) * pi / 180.
inline constexpr double kFlipPixelsPerDegree =
    0.7 * (3840.0 / 0.7) * 3.14159265358979323846 / 180.0;

struct FlipResult {
  render::FloatBuffer errors;  // channel FLIP.E, 0 (not seen) .. 1
  double mean = 0.0;
  LargestError largest;  // a and b are not used
};

// The parts of the measure, for its tests. Colours are Hunt-adjusted L*, a*, b*.
double flip_color_error(Rgbd a, Rgbd b);                      // 0 .. 1
double flip_feature_error(double edges, double points);       // of differences of strengths, 0 .. 1
double flip_error(double color_error, double feature_error);  // 0 .. 1

// Pictures as display_values.h makes them: channels R, G, B, linear Rec.709 in 0 .. 1, which is
// what the paper's first step makes of sRGB. Preconditions: the same size, pixels_per_degree > 0.
FlipResult flip(const render::FloatBuffer& a, const render::FloatBuffer& b,
                double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace alhazen
