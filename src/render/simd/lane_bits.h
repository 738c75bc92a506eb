// render/simd: the bits of lanes of double (core/math/real_bits.h).
#pragma once

#include <bit>
#include <cstdint>

#include "core/math/real_bits.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// Each lane with the bits of the other kind of number, which is as wide.
template <class To, class From, int W>
inline Lanes<To, W> bits_as(const Lanes<From, W>& from) {
  static_assert(sizeof(To) == sizeof(From));
  using Result = Lanes<To, W>;
  if constexpr (Result::kForm == Form::vector) {
    return Result::from_value(vector_bits<typename Result::Value>(from.value));
  } else if constexpr (Result::kForm == Form::pair) {
    return Result::joined(bits_as<To>(from.low()), bits_as<To>(from.high()));
  } else {
    Result result;
    for (int i = 0; i < W; ++i)
      result.set(i, std::bit_cast<To>(from[i]));
    return result;
  }
}

}  // namespace alhazen::render

namespace alhazen {

template <int W>
struct BitTraits<render::Lanes<double, W>> {
  using Real = render::Lanes<double, W>;
  using Bits = render::Lanes<std::uint64_t, W>;
  static Bits bits(Real x) { return render::bits_as<std::uint64_t>(x); }
  static Real from_bits(Bits bits) { return render::bits_as<double>(bits); }
  // table[index] for whole numbers `index` from 0 to 15; lanes of others find what is of no use.
  static Real look_up(const double* table, Real index) {
    const Bits low = bits(index + kWholeShift) & 15;
    const auto inside = index >= Real(0) && index < Real(16);
    return Real::gather(table, render::bits_as<std::int64_t>(low), inside);
  }
};

}  // namespace alhazen
