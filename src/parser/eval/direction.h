// parser/eval: directions of any length to unit length.
#pragma once

#include "core/math/vec.h"

namespace alhazen::parser {

// Of length 1 to rounding, at whatever length it comes: divided by its largest component first, so
// that no square overflows or vanishes. Precondition: not zero.
inline Vec3d unit_direction(Vec3d v) {
  const double size = larger(absolute(v.x), larger(absolute(v.y), absolute(v.z)));
  return normalized(Vec3d{v.x / size, v.y / size, v.z / size});
}

inline bool is_zero(Vec3d v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

// Whether cross(a, b) stands clear of its own rounding: 2 ulp of each product (core/math/scalar.h),
// so |a||b| 4 u bounds each component.
inline bool is_parallel(Vec3d a, Vec3d b) {
  const Vec3d u = unit_direction(a), v = unit_direction(b);
  return length(cross(u, v)) <= 8 * ScalarTraits<double>::unit_roundoff();
}

}  // namespace alhazen::parser
