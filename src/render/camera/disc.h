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
  const MaskOf<Real> is_center = a == Real(0) && b == Real(0);
  const MaskOf<Real> wide = absolute(a) > absolute(b);
  const Real radius = select(wide, a, b);
  const Real eighths = select(wide, b, a) / select(is_center, Real(1), radius);
  const Real turns = select(wide, eighths / 8, Real(0.25) - eighths / 8);
  const SinCos<Real> angle = sin_cos_of_turns(turns);
  return {radius * angle.cos, radius * angle.sin};
}

}  // namespace alhazen::render
