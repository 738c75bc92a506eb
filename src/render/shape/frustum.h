// render/shape: the frustum of a cone, which covers cylinders (equal radii), cones (one radius 0)
// and all between, open or capped. Faces: 0 side, 1 cap at the smaller end, 2 cap at the larger
// end.
//
// In the frame whose z axis runs from the centre of the smaller end to that of the larger, the
// radius at height z is rho = r + k z with k >= 0, exact at the apex of a pointed cone. The side is
// x^2 + y^2 - rho^2 = 0: a sphere's equation in a space where rho counts negative, so Lagrange's
// identity gives a discriminant of minors, (x rho' - rho x')^2 + (y rho' - rho y')^2 - (x y' - y
// x')^2, which for k = 0 is Haines' perpendicular form. The quadric's second nappe has rho < 0 and
// so lies below z = 0.
//
// u is the angle around the axis over a turn. v runs along the side from base to top; on a cap it
// is the distance from the axis over the cap's radius.
#pragma once

#include "render/shape/crossing.h"
#include "render/shape/frame.h"
#include "render/shape/quadratic.h"

namespace alhazen::render {

template <class Real>
struct Frustum {
  Frame<Real> frame;
  Real height;                      // > 0
  Real small_radius, large_radius;  // not both 0
  Real slope;                       // (large_radius - small_radius) / height
  bool capped;
  bool base_is_small;  // which end the scene calls base; for v

  Real radius_at(Real z) const { return fused_multiply_add(slope, z, small_radius); }
};

namespace frustum {

inline constexpr int kSide = 0, kSmallCap = 1, kLargeCap = 2;

// A vector (x, y, rho) of the space of the side's equation.
template <class Real>
struct Cone3 {
  Real x, y, rho;
};

// Cancels for a ray almost along the side: then b is as small as a, and its error moves t whole.
template <class Real>
inline Real product(Cone3<Real> a, Cone3<Real> b) {
  const Real around = fused_multiply_add(a.x, b.x, a.y * b.y), along = a.rho * b.rho;
  const Real terms = absolute(a.x * b.x) + absolute(a.y * b.y) + absolute(along);
  if (!has_cancelled(around - along, 2 * terms)) return around - along;
  return (two_product(a.x, b.x) + two_product(a.y, b.y) - two_product(a.rho, b.rho)).hi;
}

template <class Real>
inline Real square(Cone3<Real> a) {
  const Real around = fused_multiply_add(a.x, a.x, a.y * a.y), rho_squared = a.rho * a.rho;
  if (!has_cancelled(around - rho_squared, around + rho_squared)) return around - rho_squared;
  return (two_square(a.x) + two_square(a.y) - two_square(a.rho)).hi;
}

template <class Real>
inline Real discriminant(Cone3<Real> o, Cone3<Real> d) {
  const Real xr = difference_of_products(o.x, d.rho, o.rho, d.x);
  const Real yr = difference_of_products(o.y, d.rho, o.rho, d.y);
  const Real xy = difference_of_products(o.x, d.y, o.y, d.x);
  const Real reach = fused_multiply_add(xr, xr, yr * yr), distance = xy * xy;
  if (!has_cancelled(reach - distance, reach + distance)) return reach - distance;
  return (squared(two_minor(o.x, d.rho, o.rho, d.x)) + squared(two_minor(o.y, d.rho, o.rho, d.y)) -
          squared(two_minor(o.x, d.y, o.y, d.x)))
      .hi;
}

// Cuts `span` down to the inside of the infinite cone on the side of rho >= 0.
template <class Real>
inline void cut_by_side(Span<Real>& span, Cone3<Real> o, Cone3<Real> d, bool leaves_inward) {
  const Real inf = infinity<Real>();
  const Real a = square(d) + Real(0), b = product(o, d), c = square(o);
  Real reach = discriminant(o, d);
  if (reach < Real(0)) {
    // With a <= 0, or from inside, the line does meet the cone, and a discriminant below zero is
    // one that rounding has lost.
    span.empty = span.empty || (a > Real(0) && !leaves_inward);
    reach = Real(0);
  }
  if (a == Real(0) && b == Real(0)) {
    span.empty = span.empty || c > Real(0);  // along the axis of a cylinder
    return;
  }
  const Roots<Real> roots = roots_of(Quadratic<Real>{a, b, c, reach});
  if (a >= Real(0)) {
    span.cut(roots.near, kSide, roots.far, kSide);
  } else if (d.rho > Real(0)) {
    span.cut(roots.far, kSide, inf, kSide);  // in by the upper nappe, never out again
  } else {
    span.cut(-inf, kSide, roots.near, kSide);
  }
}

// The same for a ray from the side: one root is 0, the other minus the sum of both.
template <class Real>
inline void cut_by_own_side(Span<Real>& span, Real a, Real b) {
  if (a > Real(0)) span.cut(Real(0), kSide, Real(-2) * b / a, kSide);
}

template <class Real>
inline Span<Real> span_between_ends(Real height, Real z, Real dz) {
  Span<Real> span;
  if (dz > Real(0)) {
    span.cut(-z / dz, kSmallCap, (height - z) / dz, kLargeCap);
  } else if (dz < Real(0)) {
    span.cut((height - z) / dz, kLargeCap, -z / dz, kSmallCap);
  } else {
    span.empty = !(Real(0) <= z && z <= height);
  }
  return span;
}

// Of the ends of a span, those that lie on the side: all that an open frustum has.
template <class Real>
inline Crossings<Real> on_side(const Crossings<Real>& all) {
  Crossings<Real> result;
  for (const Crossing<Real>& crossing : all) {
    if (crossing.face == kSide) result.add(crossing.t, kSide, crossing.enters);
  }
  return result;
}

}  // namespace frustum

template <class Real>
inline Crossings<Real> crossings(const Frustum<Real>& shape, const Ray<Real>& ray, Departure from) {
  using namespace frustum;
  const Vec3<Real> local_o = shape.frame.local_point(ray.origin);
  const Vec3<Real> local_d = shape.frame.local_vector(ray.direction);
  const Cone3<Real> o{local_o.x, local_o.y, shape.radius_at(local_o.z)};
  const Cone3<Real> d{local_d.x, local_d.y, shape.slope * local_d.z};
  Span<Real> span = span_between_ends(shape.height, local_o.z, local_d.z);
  Crossings<Real> result;
  if (!from.from_surface()) {
    cut_by_side(span, o, d, false);
    result = ends_of(span);
  } else if (from.face == kSide) {
    const Real b = product(o, d);
    if (!goes_below(from, b)) return result;
    cut_by_own_side(span, square(d), b);
    result = exit_of(span);
  } else {
    if (!goes_below(from, from.face == kSmallCap ? -local_d.z : local_d.z)) return result;
    cut_by_side(span, o, d, true);
    result = exit_of(span);
  }
  return shape.capped ? result : on_side(result);
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Frustum<Real>& shape, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  using namespace frustum;
  Vec3<Real> local = shape.frame.local_point(ray.at(crossing.t)), n;
  local.z = smaller(larger(local.z, Real(0)), shape.height);
  const Real from_axis = square_root(fused_multiply_add(local.x, local.x, local.y * local.y));
  Real u{}, v;
  if constexpr (with_coordinates) u = turn_of(local.x, local.y);
  if (crossing.face == kSide) {
    const Real rho = shape.radius_at(local.z);
    const Real cosine = from_axis > Real(0) ? local.x / from_axis : Real(0);
    const Real sine = from_axis > Real(0) ? local.y / from_axis : Real(0);
    local.x = rho * cosine;
    local.y = rho * sine;
    n = normalized(Vec3<Real>(cosine, sine, -shape.slope));
    v = local.z / shape.height;
    if (!shape.base_is_small) v = Real(1) - v;
  } else {
    const bool small = crossing.face == kSmallCap;
    const Real rho = small ? shape.small_radius : shape.large_radius;
    local.z = small ? Real(0) : shape.height;
    if (from_axis > rho) {
      local.x *= rho / from_axis;
      local.y *= rho / from_axis;
    }
    n = {Real(0), Real(0), small ? Real(-1) : Real(1)};
    v = rho > Real(0) ? smaller(from_axis / rho, Real(1)) : Real(0);
  }
  const Vec3<Real> normal = shape.frame.vector(n);
  return {shape.frame.point(local), normal, normal, u, v};
}

template <class Real>
inline bool contains(const Frustum<Real>& shape, Vec3<Real> point) {
  if (!shape.capped) return false;
  const Vec3<Real> local = shape.frame.local_point(point);
  return Real(0) < local.z && local.z < shape.height &&
         frustum::square(frustum::Cone3<Real>{local.x, local.y, shape.radius_at(local.z)}) <
             Real(0);
}

}  // namespace alhazen::render
