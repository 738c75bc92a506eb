// render/shape: the sphere. One face, 0.
//
// The discriminant is R^2 d.d - |o x d|^2 (Lagrange's identity on Haines' perpendicular form),
// whose terms do not grow with the distance of the origin. In double the error of t is a few eps
// for origins near and far and for grazing rays (docs/numerics.md, A1 to A3).
//
// u is the longitude from +x towards +z over a turn, v the latitude from -y (0) to +y (1).
#pragma once

#include "render/shape/crossing.h"
#include "render/shape/frame.h"
#include "render/shape/quadratic.h"

namespace alhazen::render {

template <class Real>
struct Sphere {
  Vec3<Real> center;
  Real radius;
};

template <class Real>
inline DoubleWord<Real> two_sphere_power(Vec3<Real> o, Real radius) {
  return two_dot(o, o) - two_square(radius);
}

// |o|^2 - radius^2.
template <class Real>
inline Real sphere_power(Vec3<Real> o, Real radius) {
  const Real squares = dot(o, o), radius_squared = radius * radius;
  const Real power_of_point = squares - radius_squared;
  if (!has_cancelled(power_of_point, squares + radius_squared)) return power_of_point;
  return two_sphere_power(o, radius).hi;
}

// For a ray that grazes, or runs along the ground of a large sphere.
template <class Real>
inline Quadratic<Real> two_word_equation(Vec3<Real> o, Vec3<Real> d, Real radius) {
  const DoubleWord<Real> a = two_dot(d, d), b = two_dot(o, d), c = two_sphere_power(o, radius);
  const DoubleWord<Real> reach = two_square(radius) * a;
  // Near the surface, b^2 and a c are the smaller terms of the two ways to write the same number.
  if (fused_multiply_add(b.hi, b.hi, absolute(a.hi * c.hi)) < reach.hi) {
    return {a.hi, b.hi, c.hi, (squared(b) - a * c).hi};
  }
  const DoubleWord<Real> moment_squared = squared(two_minor(o.y, d.z, o.z, d.y)) +
                                          squared(two_minor(o.z, d.x, o.x, d.z)) +
                                          squared(two_minor(o.x, d.y, o.y, d.x));
  return {a.hi, b.hi, c.hi, (reach - moment_squared).hi};
}

template <class Real>
inline Quadratic<Real> sphere_equation(Vec3<Real> o, Vec3<Real> d, Real radius) {
  const Vec3<Real> moment = cross(o, d);
  const Real a = dot(d, d), reach = radius * radius * a, distance = dot(moment, moment);
  const Real discriminant = reach - distance;
  // Each term has fewer than 8 roundings in it.
  if (discriminant < -8 * ScalarTraits<Real>::unit_roundoff() * (reach + distance)) {
    return {a, Real(0), Real(0), discriminant};
  }
  if (has_cancelled(discriminant, reach + distance)) return two_word_equation(o, d, radius);
  return {a, sharp_dot(o, d), sphere_power(o, radius), discriminant};
}

template <class Real>
inline Crossings<Real> crossings(const Sphere<Real>& sphere, const Ray<Real>& ray, Departure from) {
  const Vec3<Real> o = ray.origin - sphere.center, d = ray.direction;
  Span<Real> span;
  if (from.from_surface()) {
    // One root is 0, so the other is minus the sum of both.
    const Real b = dot(o, d);
    if (!goes_below(from, b)) return {};
    span.cut(Real(0), 0, Real(-2) * b / dot(d, d), 0);
    return exit_of(span);
  }
  const Quadratic<Real> equation = sphere_equation(o, d, sphere.radius);
  if (equation.discriminant < Real(0)) return {};
  const Roots<Real> roots = roots_of(equation);
  span.cut(roots.near, 0, roots.far, 0);
  return ends_of(span);
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Sphere<Real>& sphere, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  const Vec3<Real> n =
      normalized(multiply_add(crossing.t, ray.direction, ray.origin - sphere.center));
  const Vec3<Real> position = multiply_add(sphere.radius, n, sphere.center);
  if constexpr (!with_coordinates) return {position, n, n, Real(0), Real(0)};
  const Real around = square_root(fused_multiply_add(n.x, n.x, n.z * n.z));
  return {position, n, n, turn_of(n.x, n.z), 2 * atan2_turns(around, -n.y)};
}

template <class Real>
inline bool contains(const Sphere<Real>& sphere, Vec3<Real> point) {
  return sphere_power(point - sphere.center, sphere.radius) < Real(0);
}

}  // namespace alhazen::render
