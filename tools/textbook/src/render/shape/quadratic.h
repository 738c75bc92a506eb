// render/shape, as textbooks have it: every sum is taken as it is rounded. For tools/textbook-cost.
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

template <class Real, class Again>
inline Real resummed(Real sum, Real /*terms*/, const Again& /*again*/,
                     MaskOf<Real> /*wanted*/ = true) {
  return sum;
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

template <class Real>
inline Real sharp_dot(Vec3<Real> a, Vec3<Real> b, MaskOf<Real> /*wanted*/ = true) {
  return dot(a, b);
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
  const Real first = q / a, second = c / q;
  const MaskOf<Real> in_order = first < second, none = q == Real(0);
  return {select(none, Real(0), select(in_order, first, second)),
          select(none, Real(0), select(in_order, second, first))};
}

}  // namespace alhazen::render
