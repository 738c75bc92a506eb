// render/shape: the doubts (doubt.h) of the sphere, the box and the frustum.
#pragma once

#include "render/shape/box.h"
#include "render/shape/doubt.h"
#include "render/shape/frustum.h"
#include "render/shape/sphere.h"

namespace alhazen::render {

// A ray that leaves its own surface has nothing to decide: the side is known.
//
// The discriminant R^2 d.d - |o x d|^2 against (R^2 + |o|^2) d.d: a ray that passes at b = R (1 +-
// e) from the centre, D away, has the margin 2 e / (1 + (D / R)^2), near enough. Whether a root is
// ahead is the sign of |o|^2 - R^2.
template <class Real>
inline Doubts<Real> doubts(const Sphere<Real>& sphere, const Ray<Real>& ray, Departure from) {
  Doubts<Real> result;
  if (from.from_surface()) {
    for (const Crossing<Real>& c : crossings(sphere, ray, from))
      result.add_root(c.t, Real(1), Real(1));
    return result;
  }
  const Vec3<Real> o = ray.origin - sphere.center, d = ray.direction;
  const Quadratic<Real> equation = sphere_equation(o, d, sphere.radius);
  const Real squares = dot(o, o) + sphere.radius * sphere.radius;
  const Real start = share_of(sphere_power(o, sphere.radius), squares);
  const Real exists = share_of(equation.discriminant, squares * equation.a);
  if (equation.discriminant < Real(0)) {
    result.add_miss(-dot(o, d) / equation.a, exists, start);
    return result;
  }
  const Roots<Real> roots = roots_of(equation);
  result.add_root(roots.near, exists, start);
  result.add_root(roots.far, exists, start);
  return result;
}

// The gap of the slabs' parameters, or, along an axis that the ray does not move on, of its
// coordinate and the faces'.
template <class Real>
inline Doubts<Real> doubts(const Box<Real>& box, const Ray<Real>& ray, Departure from) {
  Bounds<Real> bounds;
  Doubts<Real> result;
  if (from.from_surface()) {
    const Real along = ray.direction[from.face / 2];
    if (!goes_below(from, from.face % 2 == 0 ? -along : along)) return result;
  }
  Real certainty = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const Real o = ray.origin[axis], d = ray.direction[axis];
    const Real min = box.min[axis], max = box.max[axis];
    const auto index = static_cast<std::size_t>(axis);
    if (d == Real(0)) {
      const Real gap = smaller(relative_gap(o, min), relative_gap(o, max));
      if (!(min <= o && o <= max)) {
        result.add_miss(Real(0), gap, Real(1));
        return result;
      }
      certainty = smaller(certainty, gap);
      continue;
    }
    const Real entry = d > Real(0) ? min : max, exit = d > Real(0) ? max : min;
    if (!from.from_surface()) {
      bounds.entries[index] = {(entry - o) / d, relative_gap(entry, o)};
      bounds.exits[index] = {(exit - o) / d, relative_gap(exit, o)};
    } else {
      bounds.exits[index] = {larger(Real(0), (exit - o) / d)};
    }
  }
  return doubts_between(bounds, certainty);
}

namespace frustum {

// Adds the ends of the height.
template <class Real>
inline void add_ends(Bounds<Real>& bounds, Real height, Real z, Real dz, Real z_terms, bool capped,
                     bool leaves) {
  const Bound<Real> small{-z / dz, leaves ? Real(1) : share_of(z, z_terms), capped};
  const Bound<Real> large{(height - z) / dz,
                          leaves ? Real(1) : share_of(height - z, height + z_terms), capped};
  if (!leaves) bounds.entries[0] = dz > Real(0) ? small : large;
  bounds.exits[0] = dz > Real(0) ? large : small;
  if (leaves) bounds.exits[0].t = larger(Real(0), bounds.exits[0].t);
}

// How far a parameter is from the part of the line between the ends; 0 inside of it.
template <class Real>
inline Real gap_to_ends(const Bounds<Real>& bounds, Real t) {
  if (t < bounds.entries[0].t) return relative_gap(t, bounds.entries[0].t);
  if (t > bounds.exits[0].t) return relative_gap(t, bounds.exits[0].t);
  return Real(0);
}

}  // namespace frustum

// The discriminant of the side against (x^2 + y^2 + rho^2) (x'^2 + y'^2 + rho'^2), and the gaps
// between the parameters of the side and of the ends.
template <class Real>
inline Doubts<Real> doubts(const Frustum<Real>& shape, const Ray<Real>& ray, Departure from) {
  using namespace frustum;
  const Vec3<Real> p = shape.frame.local_point(ray.origin);
  const Vec3<Real> v = shape.frame.local_vector(ray.direction);
  const Cone3<Real> o{p.x, p.y, shape.radius_at(p.z)}, d{v.x, v.y, shape.slope * v.z};
  const Real a = square(d), b = product(o, d), c = square(o);
  const Real o_terms = fused_multiply_add(o.x, o.x, fused_multiply_add(o.y, o.y, o.rho * o.rho));
  const Real d_terms = fused_multiply_add(d.x, d.x, fused_multiply_add(d.y, d.y, d.rho * d.rho));
  const bool leaves = from.from_surface();
  Doubts<Real> result;
  if (leaves && !goes_below(from, from.face == kSide ? b : from.face == kSmallCap ? -v.z : v.z)) {
    return result;
  }
  Bounds<Real> bounds;
  if (v.z == Real(0)) {
    const Real gap =
        smaller(share_of(p.z, shape.height), share_of(shape.height - p.z, shape.height));
    if (!leaves && !(Real(0) <= p.z && p.z <= shape.height)) {
      result.add_miss(Real(0), gap, Real(1));
      return result;
    }
  } else {
    add_ends(bounds, shape.height, p.z, v.z, length(ray.origin - shape.frame.origin), shape.capped,
             leaves);
  }
  if (leaves && from.face == kSide) {
    if (a > Real(0)) bounds.exits[1] = {larger(Real(0), Real(-2) * b / a)};
    return doubts_between(bounds, Real(1));
  }
  if (a == Real(0) && b == Real(0)) {
    if (c > Real(0) && !leaves) {
      result.add_miss(Real(0), share_of(c, o_terms), Real(1));
      return result;
    }
    return doubts_between(bounds, share_of(c, o_terms));
  }
  const Real reach = discriminant(o, d);
  const Real start = share_of(c, o_terms), exists = share_of(reach, o_terms * d_terms);
  if (reach < Real(0) && a > Real(0) && !leaves) {
    const Real at = -b / a;
    result.add_miss(at, larger(exists, gap_to_ends(bounds, at)), start);
    return result;
  }
  const Roots<Real> roots = roots_of(Quadratic<Real>{a, b, c, reach});
  if (!leaves && (a > Real(0) || d.rho > Real(0))) {
    bounds.entries[1] = {a >= Real(0) ? roots.near : roots.far, start};
  }
  if (a >= Real(0) || !(d.rho > Real(0))) {
    const Real t = a >= Real(0) ? roots.far : roots.near;
    bounds.exits[1] = leaves ? Bound<Real>{larger(Real(0), t)} : Bound<Real>{t, start};
  }
  return doubts_between(bounds, leaves ? Real(1) : exists);
}

}  // namespace alhazen::render
