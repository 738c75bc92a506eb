// render/shape: an orthonormal frame standing on a surface or an axis.
#pragma once

#include <tuple>

#include "core/math/vec.h"
#include "render/simd/elementary.h"

namespace alhazen::render {

template <class Real>
struct Frame {
  Vec3<Real> origin, x, y, z;

  static auto fields(auto& f) { return std::tie(f.origin, f.x, f.y, f.z); }

  Vec3<Real> local_vector(Vec3<Real> v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  Vec3<Real> local_point(Vec3<Real> p) const { return local_vector(p - origin); }
  Vec3<Real> vector(Vec3<Real> local) const {
    return multiply_add(local.x, x, multiply_add(local.y, y, local.z * z));
  }
  Vec3<Real> point(Vec3<Real> local) const {
    return multiply_add(local.x, x, multiply_add(local.y, y, multiply_add(local.z, z, origin)));
  }
};

// Two unit vectors perpendicular to the unit vector z and to each other. Exact when z lies along
// an axis; a mirrored z gives mirrored vectors up to their signs.
inline Frame<double> frame_around(Vec3d origin, Vec3d z) {
  const Vec3d size{absolute(z.x), absolute(z.y), absolute(z.z)};
  // The axis farthest from z: of equals, x before z before y, so that a plane facing up has its u
  // along x.
  const Vec3d helper = size.x <= size.y && size.x <= size.z ? Vec3d{1, 0, 0}
                       : size.z <= size.y                   ? Vec3d{0, 0, 1}
                                                            : Vec3d{0, 1, 0};
  const Vec3d y = normalized(cross(helper, z));
  return {origin, cross(z, y), y, z};
}

// The angle of (x, y) in [0, 1] turns; 1 only when it rounds to a full turn.
template <class Real>
inline Real turn_of(Real x, Real y) {
  const Real turn = atan2_turns(y, x);
  return select(turn < Real(0), turn + Real(1), turn);
}

}  // namespace alhazen::render
