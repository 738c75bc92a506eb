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
#include "render/simd/lanes.h"

namespace alhazen::render {

// A sum that has lost more than this many times its size to cancellation is done again.
inline constexpr int kLargestCancellation = 8;

template <class Real>
inline MaskOf<Real> has_cancelled(Real sum, Real terms) {
  return absolute(sum) * Real(kLargestCancellation) < terms;
}

// `sum`, or what `again` makes of it in two words where it has cancelled; elsewhere than in
// `wanted` it does not matter.
template <class Real, class Again>
inline Real resummed(Real sum, Real terms, const Again& again, MaskOf<Real> wanted = true) {
  const MaskOf<Real> lost = wanted && has_cancelled(sum, terms);
  return any(lost) ? select(lost, again().hi, sum) : sum;
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
inline Real sharp_dot(Vec3<Real> a, Vec3<Real> b, MaskOf<Real> wanted = true) {
  const Real terms = absolute(a.x * b.x) + absolute(a.y * b.y) + absolute(a.z * b.z);
  // Half the usual loss: this error goes into t whole, not by its square root.
  return resummed(
      dot(a, b), 2 * terms, [&] { return two_dot(a, b); }, wanted);
}

// a t^2 + 2 b t + c and its discriminant b^2 - a c. The others are 0 where the discriminant is
// below zero.
template <class Real>
struct Quadratic {
  Real a, b, c, discriminant;
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline Quadratic<Real> select(
    MaskOf<Real> which, const Quadratic<Real>& yes, const Quadratic<Real>& no) {
  return {select(which, yes.a, no.a), select(which, yes.b, no.b), select(which, yes.c, no.c),
          select(which, yes.discriminant, no.discriminant)};
}

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
  const Real q = select(b < Real(0), root - b, -b - root);
  const Real first = q / a, quotient = c / q;
  // |q| is the larger of |b +- root|. Only rounding in a q that has cancelled says otherwise.
  const Real limit = absolute(first);
  const Real limited = select(quotient < Real(0), -limit, limit);
  const Real second = select(absolute(quotient) > limit, limited, quotient);
  const MaskOf<Real> in_order = first < second, none = q == Real(0);
  return {select(none, Real(0), select(in_order, first, second)),
          select(none, Real(0), select(in_order, second, first))};
}

}  // namespace alhazen::render
