// core/math: exponential, logarithm and power by way of double-word numbers. Templates on a double
// or lanes of doubles; each lane gives the bits of a single number.
#pragma once

#include <limits>

#include "core/math/error_free.h"
#include "core/math/real_bits.h"

namespace alhazen::kernel {

// ln 2 in three parts; the first has 42 bits, so that its product with an exponent is exact.
inline constexpr double kLn2Head = 0x1.62e42fefa3800p-1;
inline constexpr double kLn2Middle = 0x1.ef35793c76730p-45, kLn2Tail = 0x1.f97b57a079a19p-103;

// value * 2^exponent for |exponent| <= 1100, rounded once when value is normal.
template <class Real>
inline Real scaled(Real value, Real exponent) {
  Real result = value * power_of_two(exponent);
  const MaskOf<Real> above = exponent > 1023.0, below = exponent < -1022.0;
  if (any(above || below)) {
    const Real edge = select(above, Real(1023), Real(-1022));
    const Real in_two = value * power_of_two<Real>(exponent - edge) * power_of_two<Real>(edge);
    result = select(above || below, in_two, result);
  }
  return result;
}

// e^x: x = k ln 2 + r with |r| <= ln(2)/2, and the Taylor series of e^r, whose first two terms are
// added without loss. Error < 0.53 ulp for exact x, before a subnormal result is rounded.
template <class Real>
inline Real exp_of_word(DoubleWord<Real> x) {
  constexpr double kLog2E = 0x1.71547652b82fep+0;
  const Real k = round_down(fused_multiply_add(x.hi, Real(kLog2E), Real(0.5)));
  const DoubleWord<Real> r = two_sum<Real>(x.hi - k * Real(kLn2Head), -k * Real(kLn2Middle)) + x.lo;
  constexpr double kInverseFactorial[] = {
      1. / 2,         1. / 6,          1. / 24,         1. / 120,     1. / 720,
      1. / 5040,      1. / 40320,      1. / 362880,     1. / 3628800, 1. / 39916800,
      1. / 479001600, 1. / 6227020800, 1. / 87178291200};
  Real series = Real(kInverseFactorial[12]);
  for (int i = 11; i >= 0; --i)
    series = fused_multiply_add(series, r.hi, Real(kInverseFactorial[i]));
  const DoubleWord<Real> head = two_sum(Real(1), r.hi);
  // d(r^2/2) for the low word of r is r.hi * r.lo.
  const Real tail =
      fused_multiply_add(Real(r.hi * r.hi), series, fused_multiply_add(r.hi, r.lo, r.lo));
  const Real result = scaled<Real>(head.hi + (head.lo + tail), k);
  return select(x.hi > 709.8, Real(infinity<double>()), select(x.hi < -746.0, Real(0), result));
}

// ln x for finite x > 0, relative error < 2^-64: x = 2^k m with m in [sqrt(1/2), sqrt 2), and
// ln m = 2 artanh s = 2 s (1 + z/3 + z^2/5 + ...), s = (m - 1)/(m + 1), z = s^2 < 0.0295.
// The first two quotients are taken in two words, the rest is below 2^-12 of the whole.
template <class Real>
inline DoubleWord<Real> log_word(Real x) {
  using Word = DoubleWord<Real>;
  const Parts<Real> parts = parts_of(x);
  const MaskOf<Real> over = parts.significand > 0x1.6a09e667f3bcdp+0;
  const Real m = select(over, Real(parts.significand * Real(0.5)), parts.significand);
  const Real k = select(over, Real(parts.exponent + Real(1)), parts.exponent);
  const Word s = Word{m - Real(1), Real(0)} / two_sum(m, Real(1));
  const Word z = s * s;
  Real series = Real(1. / 27);
  for (int odd = 25; odd >= 7; odd -= 2)
    series = fused_multiply_add(series, z.hi, Real(1. / odd));
  const Word third = word_of<Real>(0x1.5555555555555p-2, 0x1.5555555555555p-56);
  const Word fifth = word_of<Real>(0x1.999999999999ap-3, -0x1.999999999999ap-57);
  const Word sum = (z * (third + z * (fifth + z * series))) + Real(1);
  const Word log_m = s * sum * Real(2);
  const MaskOf<Real> is_m = k == Real(0);
  if (all(is_m)) return log_m;
  const Word whole = (word_of<Real>(kLn2Middle, kLn2Tail) * k + log_m) + Real(k * Real(kLn2Head));
  return select(is_m, log_m, whole);
}

template <class Real>
inline Real exp_of(Real x) {
  return select(is_nan(x), x, exp_of_word<Real>({x, Real(0)}));
}

template <class Real>
inline Real log_of(Real x) {
  const Real inf = Real(infinity<double>());
  Real result = log_word(x).hi;
  const MaskOf<Real> usual = x > Real(0) && x < inf;
  if (!all(usual)) {
    result = select(usual, result, x);  // infinity and NaN
    result = select(x == Real(0), -inf, result);
    result = select(x < Real(0), Real(std::numeric_limits<double>::quiet_NaN()), result);
  }
  return result;
}

// power() where an argument is none of a positive finite base and a finite exponent other than 0.
template <class Real>
inline Real special_power(Real base, Real exponent) {
  const Real inf = Real(infinity<double>()), none = Real(0);
  const MaskOf<Real> up = exponent > Real(0);
  Real result = select((base > Real(1)) == up, inf, none);
  result = select(base == inf, select(up, inf, none), result);
  result = select(base == Real(0), select(up, none, inf), result);
  result = select(is_nan(base) || is_nan(exponent) || base < Real(0),
                  Real(std::numeric_limits<double>::quiet_NaN()), result);
  return select(exponent == Real(0) || base == Real(1), Real(1), result);
}

template <class Real>
inline Real power(Real base, Real exponent) {
  const Real inf = Real(infinity<double>());
  const MaskOf<Real> usual = base > Real(0) && base < inf && absolute(exponent) < inf &&
                             exponent != Real(0) && base != Real(1);
  if (!any(usual)) return special_power(base, exponent);
  const DoubleWord<Real> log_base = log_word(base);
  const Real size = log_base.hi * exponent;
  // Far outside of the range the low word would be inf - inf.
  const Real result = exp_of_word<Real>(
      select(absolute(size) > Real(1000), DoubleWord<Real>{size, Real(0)}, log_base * exponent));
  return all(usual) ? result : select(usual, result, special_power(base, exponent));
}

}  // namespace alhazen::kernel
