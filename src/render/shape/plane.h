// render/shape: the plane dot(normal, p) = offset. One face, 0, which encloses the half-space
// below.
//
// t = (offset - n.o) / n.d: relative error of a few eps of |n.o|+|offset| over their difference, at
// any grazing angle, and no farthest distance. u and v are affine coordinates in the plane, one
// unit of length in the object frame each, unbounded.
#pragma once

#include "render/shape/crossing.h"

namespace alhazen::render {

template <class Real>
struct Plane {
  Vec3<Real> normal;  // unit length to rounding
  Real offset;
  // u = dot(u_axis, p) + u_offset, and likewise v.
  Vec3<Real> u_axis, v_axis;
  Real u_offset, v_offset;
};

template <class Real>
inline Crossings<Real> crossings(const Plane<Real>& plane, const Ray<Real>& ray, Departure from) {
  Crossings<Real> result;
  const Real along = dot(plane.normal, ray.direction);
  if (from.from_surface() || along == Real(0)) return result;
  result.add((plane.offset - dot(plane.normal, ray.origin)) / along, 0, along < Real(0));
  return result;
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Plane<Real>& plane, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  const Vec3<Real> near_plane = ray.at(crossing.t), n = plane.normal;
  const Vec3<Real> position = multiply_add(plane.offset - dot(n, near_plane), n, near_plane);
  return {position, n, n, dot(plane.u_axis, position) + plane.u_offset,
          dot(plane.v_axis, position) + plane.v_offset};
}

template <class Real>
inline bool contains(const Plane<Real>& plane, Vec3<Real> point) {
  return dot(plane.normal, point) < plane.offset;
}

}  // namespace alhazen::render
