// app/nff: directions that may be of any length, and flat triangles.
#pragma once

#include "core/math/vec.h"

namespace alhazen {

inline bool is_zero(Vec3d v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

// Of length 1: divided by the largest component first, so that no square overflows or vanishes.
// Precondition: not zero.
inline Vec3d to_unit(Vec3d v) {
  return normalized(v / larger(absolute(v.x), larger(absolute(v.y), absolute(v.z))));
}

// Whether the cross product of two directions is hardly more than rounding: each of its components
// is off by at most 4 u, their sum in squares by 7 u. The scene's reader refuses what is within
// 8 u, so 16 u keeps what passes here clear of it. Precondition: neither is zero.
inline bool is_along(Vec3d a, Vec3d b) {
  return length(cross(to_unit(a), to_unit(b))) <= 16 * ScalarTraits<double>::unit_roundoff();
}

// Whether three points make a triangle and not a line, to rounding.
inline bool has_area(Vec3d a, Vec3d b, Vec3d c) {
  return !(a == b) && !(b == c) && !(c == a) && !is_along(b - a, c - a);
}

}  // namespace alhazen
