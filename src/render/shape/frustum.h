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

#include <tuple>

#include "render/shape/frame.h"
#include "render/shape/quadratic.h"
#include "render/shape/span.h"

namespace alhazen::render {

template <class Real>
struct Frustum {
  Frame<Real> frame;
  Real height;                      // > 0
  Real small_radius, large_radius;  // not both 0
  Real slope;                       // (large_radius - small_radius) / height
  MaskOf<Real> capped;
  MaskOf<Real> base_is_small;  // which end the scene calls base; for v

  static auto fields(auto& f) {
    return std::tie(f.frame, f.height, f.small_radius, f.large_radius, f.slope, f.capped,
                    f.base_is_small);
  }

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
  return resummed(around - along, 2 * terms, [&] {
    return two_product(a.x, b.x) + two_product(a.y, b.y) - two_product(a.rho, b.rho);
  });
}

template <class Real>
inline Real square(Cone3<Real> a) {
  const Real around = fused_multiply_add(a.x, a.x, a.y * a.y), rho_squared = a.rho * a.rho;
  return resummed(around - rho_squared, around + rho_squared,
                  [&] { return two_square(a.x) + two_square(a.y) - two_square(a.rho); });
}

template <class Real>
inline Real discriminant(Cone3<Real> o, Cone3<Real> d) {
  const Real xr = difference_of_products(o.x, d.rho, o.rho, d.x);
  const Real yr = difference_of_products(o.y, d.rho, o.rho, d.y);
  const Real xy = difference_of_products(o.x, d.y, o.y, d.x);
  const Real reach = fused_multiply_add(xr, xr, yr * yr), distance = xy * xy;
  return resummed(reach - distance, reach + distance, [&] {
    return squared(two_minor(o.x, d.rho, o.rho, d.x)) + squared(two_minor(o.y, d.rho, o.rho, d.y)) -
           squared(two_minor(o.x, d.y, o.y, d.x));
  });
}

// Cuts `span` down to the inside of the infinite cone on the side of rho >= 0.
template <class Real>
inline void cut_by_side(Span<Real>& span, Cone3<Real> o, Cone3<Real> d, bool leaves_inward,
                        MaskOf<Real> where = true) {
  using Mask = MaskOf<Real>;
  const Real inf = infinity<Real>();
  const Real a = square(d) + Real(0), b = product(o, d), c = square(o);
  const Real reach = discriminant(o, d);
  // With a <= 0, or from inside, the line does meet the cone, and a discriminant below zero is one
  // that rounding has lost.
  const Mask passes = reach < Real(0) && a > Real(0) && !leaves_inward;
  const Mask along_cylinder = a == Real(0) && b == Real(0);
  span.empty = span.empty || (where && (passes || (along_cylinder && c > Real(0))));
  const Roots<Real> roots = roots_of(Quadratic<Real>{a, b, c, larger(reach, Real(0))});
  // With a < 0 in by the upper nappe and never out again, or the other way round.
  const Mask twice = a >= Real(0), inward = d.rho > Real(0);
  const Real from = select(twice, roots.near, select(inward, roots.far, -inf));
  const Real to = select(twice, roots.far, select(inward, inf, roots.near));
  span.cut(from, kSide, to, kSide, where && !along_cylinder);
}

// The same for a ray from the side: one root is 0, the other minus the sum of both.
template <class Real>
inline void cut_by_own_side(Span<Real>& span, Real a, Real b, MaskOf<Real> where) {
  span.cut(Real(0), kSide, Real(-2) * b / a, kSide, where && a > Real(0));
}

template <class Real>
inline Span<Real> span_between_ends(Real height, Real z, Real dz) {
  using Int = IntOf<Real>;
  const MaskOf<Real> up = dz > Real(0), moves = up || dz < Real(0);
  const Real to_small = -z / dz, to_large = (height - z) / dz;
  const Int small(kSmallCap), large(kLargeCap);
  Span<Real> span;
  span.cut(select(up, to_small, to_large), select(up, small, large), select(up, to_large, to_small),
           select(up, large, small), moves);
  span.empty = !moves && !(Real(0) <= z && z <= height);
  return span;
}

// A ray as seen from the axis.
template <class Real>
struct SeenRay {
  Real z, dz;
  Cone3<Real> o, d;

  SeenRay(const Frustum<Real>& shape, const Ray<Real>& ray) {
    const Vec3<Real> origin = shape.frame.local_point(ray.origin);
    const Vec3<Real> direction = shape.frame.local_vector(ray.direction);
    z = origin.z;
    dz = direction.z;
    o = {origin.x, origin.y, shape.radius_at(z)};
    d = {direction.x, direction.y, shape.slope * dz};
  }
};

// Those on the side, which is all that an open frustum has.
template <class Real>
inline CrossingPair<Real> on_surface(const Frustum<Real>& shape, CrossingPair<Real> all) {
  all.has_near = all.has_near && (shape.capped || all.near.face == IntOf<Real>(kSide));
  all.has_far = all.has_far && (shape.capped || all.far.face == IntOf<Real>(kSide));
  return all;
}

}  // namespace frustum

template <class Real>
inline CrossingPair<Real> crossings(const Frustum<Real>& shape, const Ray<Real>& ray) {
  using namespace frustum;
  const SeenRay<Real> seen(shape, ray);
  Span<Real> span = span_between_ends(shape.height, seen.z, seen.dz);
  if (all(span.empty)) return {};
  cut_by_side(span, seen.o, seen.d, false);
  return on_surface(shape, ends_of(span));
}

template <class Real>
inline CrossingPair<Real> own_crossings(const Frustum<Real>& shape, const Ray<Real>& ray,
                                        const OwnDeparture<Real>& from) {
  using namespace frustum;
  using Int = IntOf<Real>;
  const SeenRay<Real> seen(shape, ray);
  const MaskOf<Real> from_side = from.face == Int(kSide);
  const Real b = product(seen.o, seen.d);
  const Real off_cap = select(from.face == Int(kSmallCap), -seen.dz, seen.dz);
  const MaskOf<Real> inward = goes_below(from, select(from_side, b, off_cap));
  if (!any(inward)) return {};
  Span<Real> span = span_between_ends(shape.height, seen.z, seen.dz);
  if (any(from_side)) cut_by_own_side(span, square(seen.d), b, from_side);
  if (!all(from_side)) cut_by_side(span, seen.o, seen.d, true, !from_side);
  return on_surface(shape, exit_of(span, inward));
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Frustum<Real>& shape, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  using namespace frustum;
  using Mask = MaskOf<Real>;
  const Vec3<Real> there = shape.frame.local_point(ray.at(crossing.t));
  const Real z = smaller(larger(there.z, Real(0)), shape.height);
  const Real from_axis = square_root(fused_multiply_add(there.x, there.x, there.y * there.y));
  const Mask on_side = crossing.face == IntOf<Real>(kSide);
  const Mask on_small = crossing.face == IntOf<Real>(kSmallCap);
  // On the side, at the radius of its height.
  const Real rho = shape.radius_at(z);
  const Mask off_axis = from_axis > Real(0);
  const Real cosine = select(off_axis, there.x / from_axis, Real(0));
  const Real sine = select(off_axis, there.y / from_axis, Real(0));
  const Vec3<Real> side{rho * cosine, rho * sine, z};
  const Vec3<Real> side_normal = normalized(Vec3<Real>(cosine, sine, -shape.slope));
  // On a cap, within its radius.
  const Real rim = select(on_small, shape.small_radius, shape.large_radius);
  const Real pull = select(from_axis > rim, rim / from_axis, Real(1));
  const Vec3<Real> cap{there.x * pull, there.y * pull, select(on_small, Real(0), shape.height)};
  const Vec3<Real> cap_normal{Real(0), Real(0), select(on_small, Real(-1), Real(1))};

  const Vec3<Real> normal = shape.frame.vector(select(on_side, side_normal, cap_normal));
  const Vec3<Real> position = shape.frame.point(select(on_side, side, cap));
  if constexpr (!with_coordinates) return {position, normal, normal};
  const Real along = z / shape.height;
  const Real upwards = select(shape.base_is_small, along, Real(1) - along);
  const Real across = select(rim > Real(0), smaller(from_axis / rim, Real(1)), Real(0));
  return {position, normal, normal, turn_of(there.x, there.y), select(on_side, upwards, across)};
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
