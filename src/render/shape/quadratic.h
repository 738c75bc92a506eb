// render/shape: the sums whose cancellation decides hit or miss on a curved surface, and the roots
// made of them.
//
// Along origin o + t d a quadric is a t^2 + 2 b t + c = 0. Two of its numbers can cancel: the
// discriminant of a ray that grazes, and c of an origin near the surface. Both are first summed in
// Real; when a sum is small beside its terms, it is summed again in two words. The filter compares
// a sum with its own terms, so it is the same at every scale.
#pragma once

#include "core/math/error_free.h"
#include "core/math/vec.h"

namespace alhazen::render {

// A sum that has lost more than this many times its size to cancellation is done again.
inline constexpr int kLargestCancellation = 8;

template <class Real>
inline bool has_cancelled(Real sum, Real terms) {
  return absolute(sum) * Real(kLargestCancellation) < terms;
}

template <class Real>
inline DoubleWord<Real> two_square(Real x) {
  return two_product(x, x);
}
template <class Real>
inline DoubleWord<Real> two_minor(Real a, Real b, Real c, Real d) {  // a*b - c*d
  return two_product(a, b) - two_product(c, d);
}
template <class Real>
inline DoubleWord<Real> squared(DoubleWord<Real> a) {
  return a * a;
}

template <class Real>
inline DoubleWord<Real> two_dot(Vec3<Real> a, Vec3<Real> b) {
  return two_product(a.x, b.x) + two_product(a.y, b.y) + two_product(a.z, b.z);
}

// dot(a, b), to few roundings also where its terms cancel: the speed at which a ray nears a surface
// that it grazes.
template <class Real>
inline Real sharp_dot(Vec3<Real> a, Vec3<Real> b) {
  const Real sum = dot(a, b);
  const Real terms = absolute(a.x * b.x) + absolute(a.y * b.y) + absolute(a.z * b.z);
  // Half the usual loss: this error goes into t whole, not by its square root.
  return has_cancelled(sum, 2 * terms) ? two_dot(a, b).hi : sum;
}

// a t^2 + 2 b t + c and its discriminant b^2 - a c. The others are 0 where the discriminant is
// below zero.
template <class Real>
struct Quadratic {
  Real a, b, c, discriminant;
};

// The parameters at which the line crosses the quadric, near <= far, from a discriminant >= 0 and
// a != 0; the form that adds numbers of one sign (Numerical Recipes 5.6).
template <class Real>
struct Roots {
  Real near, far;
};

template <class Real>
inline Roots<Real> roots_of(const Quadratic<Real>& equation) {
  const auto& [a, b, c, discriminant] = equation;
  const Real root = square_root(larger(discriminant, Real(0)));
  const Real q = b < Real(0) ? root - b : -b - root;
  if (q == Real(0)) return {Real(0), Real(0)};
  const Real first = q / a;
  Real second = c / q;
  // |q| is the larger of |b +- root|. Only rounding in a q that has cancelled says otherwise.
  if (absolute(second) > absolute(first))
    second = second < Real(0) ? -absolute(first) : absolute(first);
  return first < second ? Roots<Real>{first, second} : Roots<Real>{second, first};
}

}  // namespace alhazen::render
