// core/math: sine and cosine of an angle reduced to an eighth of a turn, and of turns. Templates on
// a double or lanes of doubles; each lane gives the bits of a single number.
#pragma once

#include <initializer_list>

#include "core/math/elementary.h"
#include "core/math/error_free.h"
#include "core/math/real_bits.h"

namespace alhazen::kernel {

template <class Real>
struct SinCosWords {
  DoubleWord<Real> sin, cos;
};

// Taylor series for |p| <= pi/4. The terms of degree up to 3 are summed in two words, the others
// are below 1/70 of the whole: relative error < 2^-58, before the two words become one.
template <class Real>
inline SinCosWords<Real> sin_cos_of_radians(DoubleWord<Real> p) {
  using Word = DoubleWord<Real>;
  const Word sixth = word_of<Real>(0x1.5555555555555p-3, 0x1.5555555555555p-57);
  const Real z = p.hi * p.hi;
  Real s = Real(1. / 355687428096000), c = Real(1. / 20922789888000);
  for (const double term :
       {-1. / 1307674368000, 1. / 6227020800, -1. / 39916800, 1. / 362880, -1. / 5040, 1. / 120}) {
    s = fused_multiply_add(s, z, Real(term));
  }
  for (const double term :
       {-1. / 87178291200, 1. / 479001600, -1. / 3628800, 1. / 40320, -1. / 720, 1. / 24}) {
    c = fused_multiply_add(c, z, Real(term));
  }
  const Word square = two_product(p.hi, p.hi);
  const Word cubic = -(square * p.hi * sixth) + p.hi;
  const Word quadratic = square * Real(-0.5) + Real(1);
  const Real sin_low =
      fused_multiply_add(p.lo, fused_multiply_add(z, Real(-0.5), Real(1)), cubic.lo);
  const Real cos_low = fused_multiply_add<Real>(-p.hi, p.lo, quadratic.lo);
  return {quick_two_sum(cubic.hi, fused_multiply_add<Real>(z * z * p.hi, s, sin_low)),
          quick_two_sum(quadratic.hi, fused_multiply_add<Real>(z * z, c, cos_low))};
}

// The sine and cosine of p + a number of quarter turns from 0 to 4.
template <class Real>
inline SinCosWords<Real> turned_by_quarters(SinCosWords<Real> p, Real quarters) {
  using Mask = MaskOf<Real>;
  const Mask one = quarters == Real(1), two = quarters == Real(2), three = quarters == Real(3);
  const DoubleWord<Real> sin = select(one || three, p.cos, p.sin);
  const DoubleWord<Real> cos = select(one || three, p.sin, p.cos);
  return {select(two || three, -sin, sin), select(one || two, -cos, cos)};
}

// At a multiple of 90 degrees 0 comes out as +0, whichever quadrant it was approached from.
template <class Real>
inline Real rounded(DoubleWord<Real> value) {
  return value.hi + Real(0);
}

template <class Real>
inline SinCos<Real> sin_cos_of_turns(Real u) {
  const Real size = absolute(u);
  const Real within_turn = size - round_down(size);  // exact
  const Real quarters = round_down(fused_multiply_add(Real(4), within_turn, Real(0.5)));
  const Real rest = fused_multiply_add(Real(-0.25), quarters, within_turn);  // exact
  const DoubleWord<Real> radians_per_turn =
      word_of<Real>(0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52);
  const SinCosWords<Real> p =
      turned_by_quarters(sin_cos_of_radians(radians_per_turn * rest), quarters);
  return {with_sign_of(u, rounded(p.sin)), rounded(p.cos)};
}

}  // namespace alhazen::kernel
