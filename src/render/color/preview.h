// render/color: a scene-linear picture as bytes that a display shows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/color/color_transform.h"

namespace alhazen::render {

// Interleaved R, G, B. `view` is a display transform; its values are clamped to 0 .. 1 and rounded
// to the nearest of 256 steps, without dither: a preview is compared as often as it is looked at.
// NaN becomes 0. Precondition: the three planes have the same size.
std::vector<std::uint8_t> preview_rgb8(const ColorTransform& view, std::span<const float> red,
                                       std::span<const float> green, std::span<const float> blue);

}  // namespace alhazen::render
