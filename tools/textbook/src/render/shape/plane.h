// render/shape, as textbooks have it: the plane by two dot products. For tools/textbook-cost.
#pragma once

#include <tuple>

#include "render/shape/crossing.h"
#include "render/shape/quadratic.h"

namespace alhazen::render {

template <class Real>
struct Plane {
  Vec3<Real> normal;  // unit length to rounding
  Real offset;
  // u = dot(u_axis, p) + u_offset, and likewise v.
  Vec3<Real> u_axis, v_axis;
  Real u_offset, v_offset;

  static auto fields(auto& p) {
    return std::tie(p.normal, p.offset, p.u_axis, p.v_axis, p.u_offset, p.v_offset);
  }
};

template <class Real>
inline Real depth_below(const Plane<Real>& plane, Vec3<Real> p) {
  return plane.offset - dot(plane.normal, p);
}

template <class Real>
inline CrossingPair<Real> crossings(const Plane<Real>& plane, const Ray<Real>& ray) {
  const Real along = dot(plane.normal, ray.direction);
  CrossingPair<Real> result;
  result.set_near(along != Real(0), depth_below(plane, ray.origin) / along, 0, along < Real(0));
  return result;
}

// It is flat, so no ray that leaves it comes back.
template <class Real>
inline CrossingPair<Real> own_crossings(const Plane<Real>& /*plane*/, const Ray<Real>& /*ray*/,
                                        const OwnDeparture<Real>& /*from*/) {
  return {};
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
