// render/shape: the plane dot(normal, p) = offset. One face, 0, which encloses the half-space
// below.
//
// t = (offset - n.o) / n.d. Either may cancel, of an origin near the plane and of a ray along it;
// then it is summed in two words (quadratic.h), and t is right to a few eps at any angle and any
// distance. u and v are affine coordinates in the plane, one unit of length in the object frame
// each, unbounded.
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

// start + dot(a, b) as if summed in twice the precision: error <= u |sum| + 5 u^2 (terms), whatever
// cancels (T. Ogita, S. M. Rump, S. Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput.
// 26(6), 2005, algorithm Dot2). It has no branch.
template <class Real>
inline Real compensated_dot(Real start, Vec3<Real> a, Vec3<Real> b) {
  const DoubleWord<Real> x = two_product(a.x, b.x), y = two_product(a.y, b.y),
                         z = two_product(a.z, b.z);
  const DoubleWord<Real> two = two_sum(x.hi, y.hi), three = two_sum(two.hi, z.hi),
                         four = two_sum(three.hi, start);
  return four.hi + ((x.lo + y.lo) + (z.lo + two.lo) + (three.lo + four.lo));
}

// offset - dot(normal, p): how far below the plane a point is.
template <class Real>
inline Real depth_below(const Plane<Real>& plane, Vec3<Real> p) {
  return compensated_dot(plane.offset, -plane.normal, p);
}

template <class Real>
inline CrossingPair<Real> crossings(const Plane<Real>& plane, const Ray<Real>& ray) {
  const Real along = compensated_dot(Real(0), plane.normal, ray.direction);
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
