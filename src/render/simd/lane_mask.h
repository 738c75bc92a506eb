// render/simd: the answers to a question about W numbers.
#pragma once

#include <cstdint>

#include "render/simd/store_array.h"
#include "render/simd/store_pair.h"
#if ALHAZEN_SIMD_SSE2
#include "render/simd/store_vector.h"
#endif

namespace alhazen::render {

// A yes or no for each of W lanes of numbers of `Bytes` bytes: lanes of double and of std::int64_t
// have the same masks.
template <int Bytes, int W>
struct LaneMask {
  using Store = MaskStore<Bytes, W>;
  using Value = typename Store::Value;

  Value value;

  LaneMask() : LaneMask(false) {}
  LaneMask(bool all) : value(Store::all_of(all)) {}  // a bool is the same answer in every lane
  // The answers about numbers of another size.
  template <int Other>
  requires(Other != Bytes) explicit LaneMask(LaneMask<Other, W> other)
      : LaneMask(from_bits(other.bits())) {}

  static LaneMask from_value(const Value& value) {
    LaneMask result;
    result.value = value;
    return result;
  }
  // The lanes below `count`: the tail of a list that does not fill the last lanes.
  static LaneMask first(int count) { return from_bits(low_bits(count)); }
  // Bit i is lane i; the bits from W on do not matter.
  static LaneMask from_bits(std::uint32_t bits) { return from_value(Store::from_bits(bits)); }
  std::uint32_t bits() const { return Store::bits(value); }
  bool operator[](int i) const { return ((bits() >> i) & 1U) != 0; }

  friend LaneMask operator&&(LaneMask a, LaneMask b) {
    return from_value(Store::both(a.value, b.value));
  }
  friend LaneMask operator||(LaneMask a, LaneMask b) {
    return from_value(Store::either(a.value, b.value));
  }
  friend LaneMask operator!=(LaneMask a, LaneMask b) {
    return from_value(Store::differing(a.value, b.value));
  }
  friend LaneMask operator!(LaneMask a) { return a != LaneMask(true); }
  friend LaneMask operator==(LaneMask a, LaneMask b) { return !(a != b); }
};

template <int Bytes, int W>
inline bool any(LaneMask<Bytes, W> mask) {
  return mask.bits() != 0;
}
template <int Bytes, int W>
inline bool all(LaneMask<Bytes, W> mask) {
  return mask.bits() == low_bits(W);
}
template <int Bytes, int W>
inline int count(LaneMask<Bytes, W> mask) {
  return __builtin_popcount(mask.bits());
}
// Calls visit(i) for each lane of the mask, in order.
template <int Bytes, int W, class Visitor>
inline void for_each_lane(LaneMask<Bytes, W> mask, const Visitor& visit) {
  for (std::uint32_t left = mask.bits(); left != 0; left &= left - 1)
    visit(__builtin_ctz(left));
}

}  // namespace alhazen::render
