// render/shape: the sphere. One face, 0.
//
// The discriminant is R^2 d.d - |o x d|^2 (Lagrange's identity on Haines' perpendicular form),
// whose terms do not grow with the distance of the origin. In double the error of t is a few eps
// for origins near and far and for grazing rays (docs/numerics.md, A1 to A3).
//
// u is the longitude from +x towards +z over a turn, v the latitude from -y (0) to +y (1).
#pragma once

#include <tuple>

#include "render/shape/crossing.h"
#include "render/shape/frame.h"
#include "render/shape/quadratic.h"

namespace alhazen::render {

template <class Real>
struct Sphere {
  Vec3<Real> center;
  Real radius;

  static auto fields(auto& sphere) { return std::tie(sphere.center, sphere.radius); }
};

template <class Real>
inline DoubleWord<Real> two_sphere_power(Vec3<Real> o, Real radius) {
  return two_dot(o, o) - two_square(radius);
}

// |o|^2 - radius^2.
template <class Real>
inline Real sphere_power(Vec3<Real> o, Real radius, MaskOf<Real> wanted = true) {
  const Real squares = dot(o, o), radius_squared = radius * radius;
  return resummed(
      squares - radius_squared, squares + radius_squared,
      [&] { return two_sphere_power(o, radius); }, wanted);
}

// For a ray that grazes, or runs along the ground of a large sphere.
template <class Real>
inline Quadratic<Real> two_word_equation(Vec3<Real> o, Vec3<Real> d, Real radius) {
  const DoubleWord<Real> a = two_dot(d, d), b = two_dot(o, d), c = two_sphere_power(o, radius);
  const DoubleWord<Real> reach = two_square(radius) * a;
  Quadratic<Real> equation{a.hi, b.hi, c.hi, Real(0)};
  // Near the surface, b^2 and a c are the smaller terms of the two ways to write the same number.
  const MaskOf<Real> near = fused_multiply_add(b.hi, b.hi, absolute(a.hi * c.hi)) < reach.hi;
  if (any(near)) equation.discriminant = (squared(b) - a * c).hi;
  if (!all(near)) {
    const DoubleWord<Real> moment_squared = squared(two_minor(o.y, d.z, o.z, d.y)) +
                                            squared(two_minor(o.z, d.x, o.x, d.z)) +
                                            squared(two_minor(o.x, d.y, o.y, d.x));
    equation.discriminant = select(near, equation.discriminant, (reach - moment_squared).hi);
  }
  return equation;
}

template <class Real>
inline Quadratic<Real> sphere_equation(Vec3<Real> o, Vec3<Real> d, Real radius) {
  const Vec3<Real> moment = cross(o, d);
  const Real a = dot(d, d), reach = radius * radius * a, distance = dot(moment, moment);
  Quadratic<Real> equation{a, Real(0), Real(0), reach - distance};
  // Each term has fewer than 8 roundings in it.
  const Real rounding = 8 * ScalarTraits<Real>::unit_roundoff() * (reach + distance);
  const MaskOf<Real> met = !(equation.discriminant < -rounding);
  if (!any(met)) return equation;
  const MaskOf<Real> lost = met && has_cancelled(equation.discriminant, reach + distance);
  const MaskOf<Real> clear = met && !lost;
  if (any(clear)) {
    equation.b = sharp_dot(o, d, clear);
    equation.c = sphere_power(o, radius, clear);
    // Near the surface b^2 and a c are the smaller terms of the same number, as in two words.
    const Real powers = a * equation.c;
    const MaskOf<Real> near =
        clear && fused_multiply_add(equation.b, equation.b, absolute(powers)) < reach;
    if (any(near)) {
      equation.b = select(near, two_dot(o, d).hi, equation.b);
      equation.discriminant =
          select(near, fused_multiply_add(equation.b, equation.b, -powers), equation.discriminant);
    }
  }
  return any(lost) ? select(lost, two_word_equation(o, d, radius), equation) : equation;
}

template <class Real>
inline CrossingPair<Real> crossings(const Sphere<Real>& sphere, const Ray<Real>& ray) {
  const Quadratic<Real> equation =
      sphere_equation(ray.origin - sphere.center, ray.direction, sphere.radius);
  const MaskOf<Real> met = !(equation.discriminant < Real(0));
  if (!any(met)) return {};
  const Roots<Real> roots = roots_of(equation);
  const MaskOf<Real> exists = met && roots.near <= roots.far;
  CrossingPair<Real> result;
  result.set_near(exists, roots.near, 0, true);
  result.set_far(exists, roots.far, 0, false);
  return result;
}

// One root is 0, so the other is minus the sum of both.
template <class Real>
inline CrossingPair<Real> own_crossings(const Sphere<Real>& sphere, const Ray<Real>& ray,
                                        const OwnDeparture<Real>& from) {
  const Vec3<Real> d = ray.direction;
  const Real b = dot(ray.origin - sphere.center, d);
  const MaskOf<Real> inward = goes_below(from, b);
  if (!any(inward)) return {};
  CrossingPair<Real> result;
  result.set_far(inward, larger(Real(0), Real(-2) * b / dot(d, d)), 0, false);
  return result;
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Sphere<Real>& sphere, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  const Vec3<Real> n =
      normalized(multiply_add(crossing.t, ray.direction, ray.origin - sphere.center));
  const Vec3<Real> position = multiply_add(sphere.radius, n, sphere.center);
  if constexpr (!with_coordinates) return {position, n, n};
  const Real around = square_root(fused_multiply_add(n.x, n.x, n.z * n.z));
  return {position, n, n, turn_of(n.x, n.z), 2 * atan2_turns(around, -n.y)};
}

template <class Real>
inline bool contains(const Sphere<Real>& sphere, Vec3<Real> point) {
  return sphere_power(point - sphere.center, sphere.radius) < Real(0);
}

}  // namespace alhazen::render
