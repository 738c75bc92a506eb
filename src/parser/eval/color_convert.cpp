// parser/eval: the formulas behind srgb(), hsv() and kelvin().
#include "parser/eval/color_convert.h"

#include <bit>
#include <cstdint>

#include "core/base/hash.h"
#include "core/math/elementary.h"

namespace alhazen::parser {

double srgb_to_linear(double encoded) {
  const double size = absolute(encoded);
  const double linear = size <= 0.04045 ? size / 12.92 : power((size + 0.055) / 1.055, 2.4);
  return encoded < 0 ? -linear : linear;
}

double SrgbDecoder::linear(double encoded) {
  Known& known = known_[mix_64(std::bit_cast<std::uint64_t>(encoded)) % known_.size()];
  if (known.encoded != encoded) known = {encoded, srgb_to_linear(encoded)};
  return known.linear;
}

Rgbd working_from_rec709(const ColorMatrix& m, Rgbd c) {
  const double least = smaller(c.r, smaller(c.g, c.b)), most = largest_channel(c);
  const auto channel = [&](std::size_t row) {
    const double a = m[3 * row], b = m[3 * row + 1], d = m[3 * row + 2];
    const double value = a * c.r + b * c.g + d * c.b;
    // A mean of the channels lies between them. Published matrices have six digits and more.
    const bool is_mean = a >= 0 && b >= 0 && d >= 0 && absolute(a + b + d - 1) < 1e-5;
    return is_mean ? smaller(most, larger(least, value)) : value;
  };
  return {channel(0), channel(1), channel(2)};
}

Rgbd hsv_to_rgb(double hue, double saturation, double value) {
  const double sextants = 6 * (hue - round_down(hue));
  const double sector = round_down(sextants), f = sextants - sector;
  const double p = value * (1 - saturation);
  const double q = value * (1 - saturation * f), t = value * (1 - saturation * (1 - f));
  switch (static_cast<int>(sector)) {
    case 0:
      return {value, t, p};
    case 1:
      return {q, value, p};
    case 2:
      return {p, value, t};
    case 3:
      return {p, q, value};
    case 4:
      return {t, p, value};
    case 5:
      return {value, p, q};
    default:
      return {value, t, p};  // hue - floor(hue) rounds to 1 for hues just below a whole
  }
}

Rgbd black_body_rec709(double kelvin) {
  const double i = 1000 / kelvin;
  const double x = kelvin <= 4000 ? ((-0.2661239 * i - 0.2343589) * i + 0.8776956) * i + 0.179910
                                  : ((-3.0258469 * i + 2.1070379) * i + 0.2226347) * i + 0.240390;
  double y = 0;
  if (kelvin <= 2222) {
    y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
  } else if (kelvin <= 4000) {
    y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
  } else {
    y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  }
  // XYZ with Y = 1, then the inverse of the primaries' matrix (IEC 61966-2-1).
  const double X = x / y, Z = (1 - x - y) / y;
  return {3.2404542 * X - 1.5371385 - 0.4985314 * Z, -0.9692660 * X + 1.8760108 + 0.0415560 * Z,
          0.0556434 * X - 0.2040259 + 1.0572252 * Z};
}

}  // namespace alhazen::parser
