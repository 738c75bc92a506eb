// core/math: sums and products that keep their rounding error, and numbers of two words built on
// them. For the few places where a difference of nearly equal numbers decides a result.
//
// Sources: T. J. Dekker 1971 and D. E. Knuth (TAOCP 4.2.2) for the sums; M. Joldes, J.-M. Muller,
// V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic", ACM TOMS 44(2), 2017, for the two-word operations and their bounds. u below is the
// unit roundoff of Real.
#pragma once

#include <concepts>

#include "core/math/scalar.h"

namespace alhazen {

// The unevaluated sum hi + lo, with |lo| <= ulp(hi)/2.
template <class Real>
struct DoubleWord {
  Real hi{}, lo{};
};

// Word by word, as of numbers; of one pair scalar.h selects.
template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) constexpr DoubleWord<Real> select(
    MaskOf<Real> condition, DoubleWord<Real> yes, DoubleWord<Real> no) {
  return {select(condition, yes.hi, no.hi), select(condition, yes.lo, no.lo)};
}

// a + b exactly, unless it overflows.
template <class Real>
inline DoubleWord<Real> two_sum(Real a, Real b) {
  const Real sum = a + b;
  const Real b_part = sum - a;
  const Real a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

// a + b exactly. Precondition: a is 0 or its exponent is not below that of b.
template <class Real>
inline DoubleWord<Real> quick_two_sum(Real a, Real b) {
  const Real sum = a + b;
  return {sum, b - (sum - a)};
}

// a * b exactly, unless it overflows or its last bit lies below the smallest subnormal.
template <class Real>
inline DoubleWord<Real> two_product(Real a, Real b) {
  const Real product = a * b;
  return {product, fused_multiply_add(a, b, -product)};
}

template <class Real>
inline DoubleWord<Real> operator-(DoubleWord<Real> a) {
  return {-a.hi, -a.lo};
}

// Relative error <= 2 u^2 (algorithm 4 of Joldes et al.).
template <class Real>
inline DoubleWord<Real> operator+(DoubleWord<Real> a, Real b) {
  const DoubleWord<Real> sum = two_sum(a.hi, b);
  return quick_two_sum(sum.hi, a.lo + sum.lo);
}

// Relative error <= 3 u^2 / (1 - 4u), whatever cancels (algorithm 6).
template <class Real>
inline DoubleWord<Real> operator+(DoubleWord<Real> a, DoubleWord<Real> b) {
  const DoubleWord<Real> high = two_sum(a.hi, b.hi), low = two_sum(a.lo, b.lo);
  const DoubleWord<Real> sum = quick_two_sum(high.hi, high.lo + low.hi);
  return quick_two_sum(sum.hi, low.lo + sum.lo);
}
template <class Real>
inline DoubleWord<Real> operator-(DoubleWord<Real> a, DoubleWord<Real> b) {
  return a + -b;
}

// Relative error <= 2 u^2 (algorithm 9).
template <class Real>
inline DoubleWord<Real> operator*(DoubleWord<Real> a, Real b) {
  const DoubleWord<Real> product = two_product(a.hi, b);
  return quick_two_sum(product.hi, fused_multiply_add(a.lo, b, product.lo));
}

// Relative error <= 5 u^2 (algorithm 11).
template <class Real>
inline DoubleWord<Real> operator*(DoubleWord<Real> a, DoubleWord<Real> b) {
  const DoubleWord<Real> product = two_product(a.hi, b.hi);
  const Real crossed = fused_multiply_add(a.hi, b.lo, a.lo * b.hi);
  return quick_two_sum(product.hi, product.lo + crossed);
}

// Relative error <= 15 u^2 (algorithm 17).
template <class Real>
inline DoubleWord<Real> operator/(DoubleWord<Real> a, DoubleWord<Real> b) {
  const Real quotient = a.hi / b.hi;
  const DoubleWord<Real> remainder = a - b * quotient;
  return quick_two_sum(quotient, remainder.hi / b.hi);
}

// One Newton step on the rounded root (A. H. Karp and P. Markstein 1997); a > 0.
template <class Real>
inline DoubleWord<Real> square_root(DoubleWord<Real> a) {
  const Real root = square_root(a.hi);
  const DoubleWord<Real> residual = a - two_product(root, root);
  return quick_two_sum(root, residual.hi / (2 * root));
}

}  // namespace alhazen
