// app/compare: numbers as colours: from nearly black over violet and orange to pale yellow.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/page/html.h"

namespace alhazen {

// sRGB, 0 .. 255, of a value in 0 .. 1; others are taken to the nearer end, NaN to 0. Lightness
// grows with the value, so that the order is seen in grey too.
std::array<std::uint8_t, 3> ramp_color(double value);

// Interleaved RGB of values that are divided by `scale` first; an infinite value is 1.
std::vector<std::uint8_t> ramp_picture(std::span<const float> values, double scale);

// The ramp as a bar between the texts for 0 and 1.
Html ramp_legend(const std::string& low, const std::string& high);

}  // namespace alhazen
