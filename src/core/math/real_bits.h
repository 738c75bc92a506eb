// core/math: the bits of a double, or of lanes of doubles (render/simd/lane_bits.h), behind one set
// of names: what the elementary functions take exponents and tables from.
#pragma once

#include <bit>
#include <cstdint>

#include "core/math/error_free.h"
#include "core/math/scalar.h"

namespace alhazen {

template <class Real>
struct BitTraits;

template <>
struct BitTraits<double> {
  using Bits = std::uint64_t;
  static constexpr Bits bits(double x) { return std::bit_cast<Bits>(x); }
  static constexpr double from_bits(Bits bits) { return std::bit_cast<double>(bits); }
  // table[index] for a whole number `index`.
  static double look_up(const double* table, double index) {
    return table[static_cast<int>(index)];
  }
};

// Where a double is 1.5 * 2^52 + n, its lowest bits are those of the whole number n.
inline constexpr double kWholeShift = 0x1.8p52;

// 2^exponent for a whole number -1022 <= exponent <= 1023; something else for others.
template <class Real>
inline Real power_of_two(Real exponent) {
  using Traits = BitTraits<Real>;
  return Traits::from_bits(Traits::bits(exponent + (kWholeShift + 1023)) << 52);
}

// A positive number, significand * 2^exponent.
template <class Real>
struct Parts {
  Real significand;  // in [1, 2)
  Real exponent;
};

// Of positive finite numbers; of others something without meaning.
template <class Real>
inline Parts<Real> parts_of(Real positive) {
  using Traits = BitTraits<Real>;
  constexpr double kSmallest = 0x1p-1022;
  Real bias = Real(1023 + 0x1p52);
  const MaskOf<Real> subnormal = positive < kSmallest;
  if (any(subnormal)) {
    positive = select(subnormal, positive * Real(0x1p54), positive);
    bias = select(subnormal, Real(1023 + 54 + 0x1p52), bias);
  }
  const typename Traits::Bits bits = Traits::bits(positive);
  // 2^52 + n has the bits of the whole number n for its lowest.
  const Real exponent = Traits::from_bits((bits >> 52) | 0x4330000000000000ULL) - bias;
  return {Traits::from_bits((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL), exponent};
}

template <class Real>
inline Real with_sign_of(Real argument, Real value) {
  return select(ScalarTraits<Real>::sign_bit(argument), -value, value);
}
template <class Real>
inline DoubleWord<Real> word_of(double hi, double lo) {
  return {Real(hi), Real(lo)};
}

}  // namespace alhazen
