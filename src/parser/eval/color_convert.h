// parser/eval: colours of other spaces in the scene-linear working space.
#pragma once

#include <array>

#include "core/math/vec.h"

namespace alhazen::parser {

// Row-major, linear Rec. 709 to working space.
using ColorMatrix = std::array<double, 9>;

// The decoding of IEC 61966-2-1; odd, so that it is defined for every number.
double srgb_to_linear(double encoded);

// The same, remembered: a scene has few colours, however many shapes it gives them to, and each
// takes a power.
class SrgbDecoder {
 public:
  Rgbd operator()(Rgbd encoded) {
    return {linear(encoded.r), linear(encoded.g), linear(encoded.b)};
  }

 private:
  struct Known {
    double encoded = 0, linear = 0;
  };
  double linear(double encoded);

  std::array<Known, 256> known_{};  // by the hash of what is encoded; 0 is 0
};

// A colour within [0, 1] stays within [0, 1] where the matrix takes white to white and mixes with
// weights that are not negative: what rounding adds beyond is cut off.
Rgbd working_from_rec709(const ColorMatrix& matrix, Rgbd rec709);

// Encoded sRGB of hue in turns (1 is once around), saturation and value (Smith 1978).
Rgbd hsv_to_rgb(double hue, double saturation, double value);

// The colour of a black body in linear Rec. 709, with luminance 1. Chromaticity by the cubic fit of
// Kang et al. (2002), which is defined from 1667 K to 25000 K.
Rgbd black_body_rec709(double kelvin);
inline constexpr double kMinKelvin = 1667, kMaxKelvin = 25000;

}  // namespace alhazen::parser
