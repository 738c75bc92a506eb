// tests/hard/kernels: kernels in float and double beside the same kernels in Quad, on the very same
// numbers.
#pragma once

#include "hard/figure.h"
#include "unit/render/shape/support.h"

namespace alhazen::hard {

using render::Crossing;
using render::Crossings;
using render::Departure;
using render::Dice;
using render::Ray;
using render::Side;

template <class Real>
constexpr const char* kScalar = sizeof(Real) == sizeof(float) ? "float" : "double";

// One rounding of the type: 2^-53 or 2^-24.
template <class Real>
constexpr double kEps = static_cast<double>(ScalarTraits<Real>::unit_roundoff());

// A figure of this scalar type. `float_lacks` says why float cannot hold the bound, if it cannot.
template <class Real>
void figure_in(std::string_view id, std::string_view what, double measured, double bound,
               std::string_view unit = "", std::string_view float_lacks = "") {
  if (sizeof(Real) == sizeof(float) && !float_lacks.empty()) {
    figure_beyond(id, kScalar<Real>, what, measured, bound, unit, float_lacks);
  } else {
    figure(id, kScalar<Real>, what, measured, bound, unit);
  }
}

template <class Real>
Ray<Real> ray_of(Vec3d origin, Vec3d direction) {
  return {Vec3<Real>(origin), Vec3<Real>(direction)};
}

// A unit vector perpendicular to d, at random.
inline Vec3d aside_of(Vec3d d, Dice& dice) {
  return normalized(cross(d, dice.direction()));
}

// How much an error of one rounding in the largest of the numbers that place the ray's origin and
// the shape (`extent`, a length) moves t, relative to t: the origin's part over the distance
// travelled, and 1 / |cos| of the angle of incidence on the normal n. At least 1.
template <class Real>
double condition(Vec3<Real> n, Vec3<Real> direction, Real t, double extent) {
  const double speed = static_cast<double>(length(direction));
  const double cosine = static_cast<double>(absolute(dot(n, direction))) / speed;
  const double distance = static_cast<double>(t) * speed;
  return (extent + distance) / (distance * cosine);
}

#if ALHAZEN_HAS_QUAD
template <class Real>
Ray<Quad> exact(const Ray<Real>& ray) {
  return {Vec3<Quad>(ray.origin), Vec3<Quad>(ray.direction)};
}

// |got - truth| / |truth| in roundings of Real.
template <class Real>
double relative_error(Real got, Quad truth) {
  const Quad error = absolute(static_cast<Quad>(got) - truth);
  if (error == 0) return 0;
  return static_cast<double>(error / absolute(truth)) / kEps<Real>;
}

template <class Kernel>
double condition(const Kernel& shape, const Ray<Quad>& ray, const Crossing<Quad>& crossing,
                 double extent) {
  const Vec3<Quad> n = render::surface<false>(shape, ray, crossing).normal;
  return condition(n, ray.direction, crossing.t, extent);
}

// The roundings of the numbers in play that a crossing of a shape which is not flat may be off by.
inline constexpr double kRoundings = 16;

// The condition where it is not of first order, as for a ray that passes the tip of a cone within
// its own rounding: how far the oracle's crossing moves, per rounding, when the ray is moved along
// some axis by kRoundings of `extent`. An error of kRoundings such conditions is that of a ray so
// near to the one that was asked. Infinite where such a ray has more crossings, or fewer.
template <class Kernel>
double moved_condition(const Kernel& shape, const Ray<Quad>& ray, int index, double extent,
                       double eps) {
  const Crossings<Quad> at = crossings(shape, ray, Departure());
  const Quad step = static_cast<Quad>(kRoundings * eps * extent), t = at[index].t;
  Quad farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Quad by : {step, -step}) {
      Ray<Quad> moved = ray;
      moved.origin[axis] = ray.origin[axis] + by;
      const Crossings<Quad> there = crossings(shape, moved, Departure());
      if (there.size() != at.size()) return infinity<double>();
      farthest = larger(farthest, absolute(there[index].t - t));
    }
  }
  return static_cast<double>(farthest / t) / (kRoundings * eps);
}

// Many rays, each answered by a kernel and by the oracle.
template <class Real>
struct Verdict {
  std::size_t compared = 0, miscounted = 0;  // rays; those whose crossings differ in number
  double worst = 0;                          // relative error of t in eps
  double worst_conditioned = 0;              // the same over the condition of its crossing

  // `is_decided()`: whether the oracle's count is far enough from another to be demanded; asked
  // only when the counts differ.
  template <class Shape, class Oracle, class Decided>
  void compare(const Shape& shape, const Oracle& oracle, const Ray<Real>& ray,
               const Decided& is_decided, double extent) {
    ++compared;
    const Crossings<Real> got = crossings(shape, ray, Departure());
    const Ray<Quad> same = exact(ray);
    const Crossings<Quad> truth = crossings(oracle, same, Departure());
    if (got.size() != truth.size()) {
      if (is_decided()) ++miscounted;
      return;
    }
    for (int i = 0; i < got.size(); ++i) {
      const double error = relative_error(got[i].t, truth[i].t);
      worst = larger(worst, error);
      if (truth[i].t > Quad(0)) {
        double kappa = condition(oracle, same, truth[i], extent);
        // The costly one is asked for where the other does not explain the error.
        if (error > 0.5 * kRoundings * kappa) {
          kappa = larger(kappa, moved_condition(oracle, same, i, extent, kEps<Real>));
        }
        worst_conditioned = larger(worst_conditioned, error / kappa);
      }
    }
  }
};
#endif

}  // namespace alhazen::hard
