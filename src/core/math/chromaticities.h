// core/math: which colours the numbers of a linear RGB space stand for.
#pragma once

#include <array>

#include "core/math/vec.h"

namespace alhazen {

// A CIE 1931 chromaticity.
struct Xy {
  double x{}, y{};
  friend constexpr bool operator==(Xy a, Xy b) { return a.x == b.x && a.y == b.y; }
};

// The primaries of an RGB space and the white that (1, 1, 1) stands for.
struct Chromaticities {
  Xy red, green, blue, white;
  friend constexpr bool operator==(const Chromaticities& a, const Chromaticities& b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue && a.white == b.white;
  }
};

// ITU-R BT.709-6 table 1; the primaries and the white (D65) of sRGB too.
constexpr Chromaticities kRec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
// SMPTE RP 431-2 primaries with the D65 white of Display P3.
constexpr Chromaticities kP3D65{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
// ITU-R BT.2020-2 table 3.
constexpr Chromaticities kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
// Academy S-2014-004, ACEScg.
constexpr Chromaticities kAcesAp1{
    {0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};
// SMPTE ST 2065-1, ACES2065-1.
constexpr Chromaticities kAcesAp0{
    {0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}};

// Takes linear colours of one RGB space to another; a variable `b_from_a` reads right to left.
struct ColorMatrix {
  std::array<std::array<double, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  constexpr Rgbd operator*(Rgbd c) const { return {row(0, c), row(1, c), row(2, c)}; }
  friend constexpr bool operator==(const ColorMatrix& a, const ColorMatrix& b) {
    return a.rows == b.rows;
  }

 private:
  constexpr double row(std::size_t i, Rgbd c) const {
    return rows[i][0] * c.r + rows[i][1] * c.g + rows[i][2] * c.b;
  }
};

}  // namespace alhazen
