// render/film: one dimension of a reconstruction filter: its value and the inversion of its
// distribution function. All filters here are products of two of these, one along x and one along
// y.
#pragma once

#include <array>
#include <vector>

#include "core/scene/settings.h"

namespace alhazen::render {

// Even in x, zero beyond the radius, of integral 1. Piecewise cubic: exactly for box, tent and
// Mitchell-Netravali (B = C = 1/3, stretched from its radius of 2); a Gaussian of sigma = radius/3,
// lowered so that it ends at 0, is its Hermite interpolant in 128 pieces, within 3e-9 of its peak.
class FilterProfile {
 public:
  // `radius` > 0 in pixels.
  FilterProfile(FilterKind kind, double radius);

  double value(double x) const;

  // The point below which lies the share u in [0, 1] of the integral of |value|, to 2e-15 of that
  // integral; increases with u within [-radius, radius], and quantile(1 - u) = -quantile(u).
  double quantile(double u) const;
  // Whether the filter is negative at a point drawn by quantile().
  bool is_negative(double x) const;

  // The integrals of the positive part and of minus the negative part: they differ by 1, to
  // rounding.
  double positive_integral() const { return positive_; }
  double negative_integral() const { return negative_; }

 private:
  // On [start, start + width] of |x| / radius the absolute value is the cubic c in t from 0 to 1.
  struct Piece {
    double start, width, sign;
    std::array<double, 4> c;
    double mass_before, mass;
  };
  void append(double start, double end, double sign, const std::array<double, 4>& cubic);
  void build_gaussian();
  void build_mitchell();
  void normalise();
  const Piece& piece_at(double distance) const;

  FilterKind kind_;
  double radius_;
  std::vector<Piece> pieces_;  // from the centre outwards
  double positive_ = 1, negative_ = 0;
};

}  // namespace alhazen::render
