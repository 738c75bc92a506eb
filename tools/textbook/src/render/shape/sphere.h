// render/shape, as textbooks have it: the sphere by the discriminant b^2 - a c. For
// tools/textbook-cost.
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

template <class Real>
inline Quadratic<Real> sphere_equation(Vec3<Real> o, Vec3<Real> d, Real radius) {
  const Real a = dot(d, d), b = dot(o, d), c = dot(o, o) - radius * radius;
  return {a, b, c, b * b - a * c};
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
