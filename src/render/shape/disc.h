// render/shape: the flat disc, with or without a hole. One face, 0; it encloses nothing.
//
// u is the angle around the normal over a turn, v the distance from the inner rim (0) to the outer.
#pragma once

#include <tuple>

#include "render/shape/crossing.h"
#include "render/shape/frame.h"

namespace alhazen::render {

template <class Real>
struct Disc {
  Frame<Real> frame;  // z is the normal, the origin is the centre
  Real radius, hole_radius;

  static auto fields(auto& disc) { return std::tie(disc.frame, disc.radius, disc.hole_radius); }
};

template <class Real>
inline CrossingPair<Real> crossings(const Disc<Real>& disc, const Ray<Real>& ray) {
  const Vec3<Real> d = disc.frame.local_vector(ray.direction);
  const Vec3<Real> o = disc.frame.local_point(ray.origin);
  const Real t = -o.z / d.z;
  const Real x = fused_multiply_add(t, d.x, o.x), y = fused_multiply_add(t, d.y, o.y);
  const Real distance_squared = fused_multiply_add(x, x, y * y);
  const MaskOf<Real> within = distance_squared <= disc.radius * disc.radius &&
                              distance_squared >= disc.hole_radius * disc.hole_radius;
  CrossingPair<Real> result;
  result.set_near(within && d.z != Real(0), t, 0, d.z < Real(0));
  return result;
}

// It is flat, so no ray that leaves it comes back.
template <class Real>
inline CrossingPair<Real> own_crossings(const Disc<Real>& /*disc*/, const Ray<Real>& /*ray*/,
                                        const OwnDeparture<Real>& /*from*/) {
  return {};
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Disc<Real>& disc, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  Vec3<Real> local = disc.frame.local_point(ray.at(crossing.t));
  local.z = Real(0);
  const Vec3<Real> n = disc.frame.z;
  const Vec3<Real> position = disc.frame.point(local);
  if constexpr (!with_coordinates) return {position, n, n};
  const Real across = (length(local) - disc.hole_radius) / (disc.radius - disc.hole_radius);
  return {position, n, n, turn_of(local.x, local.y), smaller(larger(across, Real(0)), Real(1))};
}

}  // namespace alhazen::render
