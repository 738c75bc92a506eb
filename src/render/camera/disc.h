// render/camera: points spread evenly over the unit disc.
#pragma once

#include "core/math/elementary.h"

namespace alhazen::render {

template <class Real>
struct DiscPoint {
  Real x, y;
};

// (u, v) in [0, 1]^2 to the disc, area to area and squares to rings (P. Shirley and K. Chiu, "A Low
// Distortion Map Between Disk and Square", 1997). The centre goes to the centre.
template <class Real>
inline DiscPoint<Real> disc_from_square(Real u, Real v) {
  const Real a = 2 * u - 1, b = 2 * v - 1;
  if (a == 0 && b == 0) return {Real(0), Real(0)};
  const bool wide = absolute(a) > absolute(b);
  const Real radius = wide ? a : b;
  const Real turns = wide ? b / a / 8 : Real(0.25) - a / b / 8;
  const SinCos<Real> angle = sin_cos_of_turns(turns);
  return {radius * angle.cos, radius * angle.sin};
}

}  // namespace alhazen::render
