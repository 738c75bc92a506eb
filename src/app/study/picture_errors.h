// app/study: how far a picture is from the reference, in double: rounding errors of 1e-16 count.
#pragma once

#include <cstdint>
#include <vector>

#include "app/compare/display_values.h"
#include "render/wave/render.h"

namespace alhazen {

// Radiance in the working space, 3 numbers a pixel, rows from the top.
struct RgbPicture {
  int width = 0, height = 0;
  std::vector<double> rgb;

  std::size_t pixel_count() const { return rgb.size() / 3; }
};

RgbPicture rgb_of(const render::Picture& picture);
// Channels R, G, B.
render::FloatBuffer float_buffer(const RgbPicture& picture);

// What an eye sees of eight bits: one step.
inline constexpr double kVisibleStep = 1.0 / 255;

struct PictureErrors {
  double rmse = 0;                // over all channels of all pixels
  double relative_mse = 0;        // mean of (a - b)^2 / (b^2 + kRelativeEpsilon)
  double largest = 0;             // of |a - b|
  std::uint64_t pixels_over = 0;  // with a channel that differs by more than kVisibleStep
  std::uint64_t pixels = 0;
  std::uint64_t not_finite = 0;  // channels in no mean: NaN or infinite in either picture
  double flip = 0;               // mean FLIP as a display shows it

  double share_over() const;
};

// Of `a` against `reference`. Precondition: the same size.
PictureErrors errors_of(const RgbPicture& a, const RgbPicture& reference, const DisplayLook& look);

// The RMSE alone.
double rmse_of(const RgbPicture& a, const RgbPicture& b);

// The largest channel's |a - b| of each pixel; 0 where it is not a number.
std::vector<float> error_map(const RgbPicture& a, const RgbPicture& reference);

}  // namespace alhazen
