// core/math: the inverse circular functions. All come down to the angle of a point. Templates on a
// double or lanes of doubles; each lane gives the bits of a single number.
#pragma once

#include <concepts>
#include <initializer_list>
#include <limits>

#include "core/math/error_free.h"
#include "core/math/real_bits.h"

namespace alhazen::kernel {

inline constexpr double kTurnsPerRadian[2] = {0x1.45f306dc9c883p-3, -0x1.6b01ec5417056p-57};

// atan(i/8) in turns, in two words (tests/golden/elementary/make.py --constants prints them).
inline constexpr double kTurnOfEighths[] = {0,
                                            0x1.4444750777668p-6,
                                            0x1.3f670b6bdc73dp-5,
                                            0x1.d3c3a482f3ab5p-5,
                                            0x1.2e4051d9df308p-4,
                                            0x1.6c266f6edfc1ep-4,
                                            0x1.a37f5c4c419efp-4,
                                            0x1.d49ab3ac8b1bbp-4,
                                            0x1p-3};
inline constexpr double kTurnOfEighthsLow[] = {0,
                                               0x1.b7f9255cb1f1ep-60,
                                               0x1.bbe87e7941244p-61,
                                               -0x1.16f02508c9309p-61,
                                               0x1.995a23db6b8d4p-58,
                                               0x1.f0066ff5b8be7p-59,
                                               0x1.9a97709251caep-59,
                                               0x1.41af9789432fbp-58,
                                               0};

// atan(y/x) in turns for 0 <= y <= x, x > 0, neither near the ends of the exponent range. With
// c = i/8 next to y/x: atan(y/x) = atan(c) + atan(t), t = (y - c x)/(x + c y), |t| <= 1/16.
// Relative error < 2^-60: the series from the second term on is below 2^-9.5 of t.
template <class Real>
inline DoubleWord<Real> turn_in_octant(DoubleWord<Real> y, DoubleWord<Real> x) {
  using Word = DoubleWord<Real>;
  const Real i = round_down<Real>(Real(8) * (y.hi / x.hi) + Real(0.5));
  const Real c = Real(0.125) * i;
  const Word t = (y - x * c) / (x + y * c);
  const Real z = t.hi * t.hi;
  Real series = Real(-1. / 15);
  for (const double term : {1. / 13, -1. / 11, 1. / 9, -1. / 7, 1. / 5, -1. / 3}) {
    series = fused_multiply_add(series, z, Real(term));
  }
  const Word angle = quick_two_sum(t.hi, fused_multiply_add<Real>(t.hi * z, series, t.lo));
  const Word eighths = {BitTraits<Real>::look_up(kTurnOfEighths, i),
                        BitTraits<Real>::look_up(kTurnOfEighthsLow, i)};
  return eighths + angle * word_of<Real>(kTurnsPerRadian[0], kTurnsPerRadian[1]);
}

// The angle of (x, y) in [0, 1/2] turns for y >= 0, under the precondition above.
template <class Real>
inline DoubleWord<Real> turn_in_half_plane(DoubleWord<Real> y, DoubleWord<Real> x) {
  const MaskOf<Real> behind = x.hi < Real(0);
  const DoubleWord<Real> side = select(behind, -x, x);
  if constexpr (std::same_as<MaskOf<Real>, bool>) {  // a branch costs one number less than choosing
    const DoubleWord<Real> turn =
        y.hi <= side.hi ? turn_in_octant(y, side) : -turn_in_octant(side, y) + Real(0.25);
    return behind ? -turn + Real(0.5) : turn;
  }
  const MaskOf<Real> steep = y.hi > side.hi;
  DoubleWord<Real> turn = turn_in_octant(select(steep, side, y), select(steep, y, side));
  if (any(steep)) turn = select(steep, -turn + Real(0.25), turn);
  if (any(behind)) turn = select(behind, -turn + Real(0.5), turn);
  return turn;
}

// value * 2^exponent for exponent <= 64 and value between 2^-8 and 2^10, rounded at most once.
template <class Real>
inline Real scaled_down(Real value, Real exponent) {
  const MaskOf<Real> deep = exponent < Real(-900);
  const Real part = value * power_of_two<Real>(select(deep, Real(exponent + Real(900)), exponent));
  return select(exponent < Real(-1100), Real(0), select(deep, Real(part * Real(0x1p-900)), part));
}

// angle_in_half_plane() where one coordinate is 0, infinite, or 2^64 times the other: there the arc
// is its chord, which also keeps subnormal results to one rounding.
template <class Real>
inline Real angle_near_an_axis(Real y, Real x, Parts<Real> up, Parts<Real> along, Real per_turn) {
  const Real inf = Real(infinity<double>()), side = absolute(x);
  const MaskOf<Real> behind = x < Real(0);
  const Real difference = up.exponent - along.exponent;
  const DoubleWord<Real> slope =
      DoubleWord<Real>{up.significand, Real(0)} / DoubleWord<Real>{along.significand, Real(0)};
  const DoubleWord<Real> turns_per_radian = word_of<Real>(kTurnsPerRadian[0], kTurnsPerRadian[1]);
  const Real flat = scaled_down((slope * turns_per_radian * per_turn).hi, difference);
  const Real half = Real(0.5) * per_turn, quarter = Real(0.25) * per_turn;
  Real result = select(difference > Real(64), quarter, select(behind, half, flat));
  result = select(side == inf, select(behind, half, Real(0)), result);
  result = select(y == inf, quarter, result);
  result = select(y == inf && side == inf,
                  Real(select(behind, Real(0.375), Real(0.125)) * per_turn), result);
  result = select(side == Real(0), quarter, result);
  return select(y == Real(0), select(ScalarTraits<Real>::sign_bit(x), half, Real(0)), result);
}

// The angle of (x, y) for y >= 0, in units of which a turn has `per_turn`.
template <class Real>
inline Real angle_in_half_plane(Real y, Real x, Real per_turn) {
  const Real side = absolute(x), inf = Real(infinity<double>());
  const Parts<Real> up = parts_of(y), along = parts_of(side);
  const Real difference = up.exponent - along.exponent;
  const MaskOf<Real> usual =
      y > Real(0) && side > Real(0) && y < inf && side < inf && absolute(difference) <= Real(64);
  Real result = Real(0);
  if (any(usual)) {
    const DoubleWord<Real> height = {up.significand * power_of_two(difference), Real(0)};
    const DoubleWord<Real> width = {select(x < Real(0), -along.significand, along.significand),
                                    Real(0)};
    result = (turn_in_half_plane(height, width) * per_turn).hi;
  }
  if (all(usual)) return result;
  return select(usual, result, angle_near_an_axis(y, x, up, along, per_turn));
}

// sqrt(1 - x^2) for |x| < 1, without cancellation.
template <class Real>
inline DoubleWord<Real> other_leg(Real x) {
  return square_root(two_sum(Real(1), Real(-x)) * two_sum(Real(1), x));
}

template <class Real>
inline Real acos_in(Real x, Real per_turn) {
  const Real size = absolute(x), none = Real(std::numeric_limits<double>::quiet_NaN());
  const MaskOf<Real> inside = size < Real(1);
  const Real sure = select(inside, x, Real(0));  // no table has an entry for the others
  const Real result = (turn_in_half_plane<Real>(other_leg(sure), {sure, Real(0)}) * per_turn).hi;
  if (all(inside)) return result;
  const Real end = select(x < Real(0), Real(Real(0.5) * per_turn), Real(0));
  return select(inside, result, select(size == Real(1), end, none));
}

template <class Real>
inline Real atan2_turns(Real y, Real x) {
  const Real angle = with_sign_of(y, angle_in_half_plane(absolute(y), x, Real(1)));
  return select(is_nan(x) || is_nan(y), Real(std::numeric_limits<double>::quiet_NaN()), angle);
}

template <class Real>
inline Real acos_turns(Real x) {
  return acos_in(x, Real(1));
}

}  // namespace alhazen::kernel
