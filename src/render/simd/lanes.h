// render/simd: numbers side by side, one for each ray (or shape, or box) that is worked on at once.
//
// Lanes<T, W> is used like a T: kernels are templates on `Real`, and Real may be float, double,
// Quad or lanes of them. Each lane does exactly what a T would do, so a picture's bits do not
// depend on W. A comparison gives a LaneMask in the place of a bool; where a kernel for single
// numbers would branch, it selects (docs/lanes.md).
//
// This is the form that the compiler makes something of on any machine. The forms for one
// instruction set stand in lanes_x86.h; all intrinsics are there.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/math/scalar.h"

namespace alhazen::render {

// A yes or no for each of W lanes of numbers of `Bytes` bytes: lanes of double and of std::int64_t
// have the same masks.
template <int Bytes, int W>
struct LaneMask {
  std::array<bool, W> lane{};

  LaneMask() = default;
  LaneMask(bool all) { lane.fill(all); }  // a bool is the same answer in every lane

  // The lanes below `count`: the tail of a list that does not fill the last lanes.
  static LaneMask first(int count) {
    LaneMask result;
    for (int i = 0; i < W; ++i)
      result.lane[i] = i < count;
    return result;
  }
  // Bit i is lane i.
  static LaneMask from_bits(std::uint32_t bits) {
    LaneMask result;
    for (int i = 0; i < W; ++i)
      result.lane[i] = ((bits >> i) & 1U) != 0;
    return result;
  }
  std::uint32_t bits() const {
    std::uint32_t result = 0;
    for (int i = 0; i < W; ++i)
      result |= static_cast<std::uint32_t>(lane[i]) << i;
    return result;
  }
  bool operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }

  friend LaneMask operator&&(LaneMask a, LaneMask b) { return from_bits(a.bits() & b.bits()); }
  friend LaneMask operator||(LaneMask a, LaneMask b) { return from_bits(a.bits() | b.bits()); }
  friend LaneMask operator!(LaneMask a) { return from_bits(~a.bits()); }
  friend LaneMask operator==(LaneMask a, LaneMask b) { return from_bits(~(a.bits() ^ b.bits())); }
  friend LaneMask operator!=(LaneMask a, LaneMask b) { return from_bits(a.bits() ^ b.bits()); }
};

template <class T, int W>
struct Lanes {
  using Scalar = T;
  using Mask = LaneMask<static_cast<int>(sizeof(T)), W>;
  static constexpr int kWidth = W;

  std::array<T, W> lane{};

  Lanes() = default;
  // The same number in every lane. Literals and constants of any arithmetic type are welcome.
  template <class U>
  requires std::is_arithmetic_v<U> || std::same_as<U, T> Lanes(U value) {
    lane.fill(static_cast<T>(value));
  }
  template <class U>
  explicit Lanes(const Lanes<U, W>& other) {
    for (int i = 0; i < W; ++i)
      set(i, static_cast<T>(other[i]));
  }

  T operator[](int i) const { return lane[static_cast<std::size_t>(i)]; }
  void set(int i, T value) { lane[static_cast<std::size_t>(i)] = value; }

  // W numbers from memory, of any alignment, and back.
  static Lanes load(const T* from) {
    Lanes result;
    for (int i = 0; i < W; ++i)
      result.set(i, from[i]);
    return result;
  }
  void store(T* to) const {
    for (int i = 0; i < W; ++i)
      to[i] = (*this)[i];
  }
  // Stores the lanes of the mask one after the other, in order; how many there were. There must be
  // room for W.
  int store_compressed(Mask which, T* to) const {
    int count = 0;
    for (int i = 0; i < W; ++i) {
      if (which[i]) to[count++] = (*this)[i];
    }
    return count;
  }
  // base[index[i]]; lanes outside of the mask are not read and are 0.
  template <class Index>
  static Lanes gather(const T* base, const Lanes<Index, W>& index, Mask which = true) {
    Lanes result;
    for (int i = 0; i < W; ++i) {
      if (which[i]) result.set(i, base[index[i]]);
    }
    return result;
  }
  // 0, 1, ... W - 1.
  static Lanes iota() {
    Lanes result;
    for (int i = 0; i < W; ++i)
      result.set(i, static_cast<T>(i));
    return result;
  }

#define ALHAZEN_LANES_OPERATOR(op)                  \
  friend Lanes operator op(Lanes a, Lanes b) {      \
    Lanes r;                                        \
    for (int i = 0; i < W; ++i)                     \
      r.set(i, static_cast<T>(a[i] op b[i]));       \
    return r;                                       \
  }                                                 \
  friend Lanes& operator op##=(Lanes& a, Lanes b) { \
    return a = a op b;                              \
  }
  ALHAZEN_LANES_OPERATOR(+)
  ALHAZEN_LANES_OPERATOR(-)
  ALHAZEN_LANES_OPERATOR(*)
#undef ALHAZEN_LANES_OPERATOR
  friend Lanes operator/(Lanes a, Lanes b) requires(!std::is_integral_v<T>) {
    Lanes r;
    for (int i = 0; i < W; ++i)
      r.set(i, a[i] / b[i]);
    return r;
  }
  friend Lanes operator-(Lanes a) {
    Lanes r;
    for (int i = 0; i < W; ++i)
      r.set(i, static_cast<T>(-a[i]));
    return r;
  }
  // Of whole numbers.
#define ALHAZEN_LANES_OPERATOR(op)                                            \
  friend Lanes operator op(Lanes a, Lanes b) requires std::is_integral_v<T> { \
    Lanes r;                                                                  \
    for (int i = 0; i < W; ++i)                                               \
      r.set(i, static_cast<T>(a[i] op b[i]));                                 \
    return r;                                                                 \
  }
  ALHAZEN_LANES_OPERATOR(&)
  ALHAZEN_LANES_OPERATOR(|)
  ALHAZEN_LANES_OPERATOR(^)
#undef ALHAZEN_LANES_OPERATOR
  friend Lanes operator<<(Lanes a, int by) requires std::is_integral_v<T> {
    Lanes r;
    for (int i = 0; i < W; ++i)
      r.set(i, static_cast<T>(a[i] << by));
    return r;
  }
  friend Lanes operator>>(Lanes a, int by) requires std::is_integral_v<T> {
    Lanes r;
    for (int i = 0; i < W; ++i)
      r.set(i, static_cast<T>(a[i] >> by));
    return r;
  }
#define ALHAZEN_LANES_COMPARISON(op)          \
  friend Mask operator op(Lanes a, Lanes b) { \
    std::uint32_t bits = 0;                   \
    for (int i = 0; i < W; ++i)               \
      bits |= (a[i] op b[i] ? 1U : 0U) << i;  \
    return Mask::from_bits(bits);             \
  }
  ALHAZEN_LANES_COMPARISON(==)
  ALHAZEN_LANES_COMPARISON(!=)
  ALHAZEN_LANES_COMPARISON(<)
  ALHAZEN_LANES_COMPARISON(<=)
  ALHAZEN_LANES_COMPARISON(>)
  ALHAZEN_LANES_COMPARISON(>=)
#undef ALHAZEN_LANES_COMPARISON
};

// yes where the mask is set, no elsewhere.
template <class T, int W>
inline Lanes<T, W> select(typename Lanes<T, W>::Mask mask, Lanes<T, W> yes, Lanes<T, W> no) {
  Lanes<T, W> result;
  for (int i = 0; i < W; ++i)
    result.set(i, mask[i] ? yes[i] : no[i]);
  return result;
}

template <int Bytes, int W>
inline bool any(LaneMask<Bytes, W> mask) {
  return mask.bits() != 0;
}
template <int Bytes, int W>
inline bool all(LaneMask<Bytes, W> mask) {
  return mask.bits() == LaneMask<Bytes, W>(true).bits();
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

// The same names for one number, whose answers are bools.
using alhazen::all;
using alhazen::any;
using alhazen::select;

}  // namespace alhazen::render

namespace alhazen {

template <class T, int W>
struct LaneTraits<render::Lanes<T, W>> {
  using Scalar = T;
  using Mask = typename render::Lanes<T, W>::Mask;
  // As wide as T, so that masks serve both.
  using Int = render::Lanes<std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>, W>;
  static constexpr int kWidth = W;
};

// Every function of core/math/scalar.h works on lanes through this; those that ask give a mask.
template <class T, int W>
struct ScalarTraits<render::Lanes<T, W>> {
  using Lanes = render::Lanes<T, W>;
  using Mask = typename Lanes::Mask;
  using One = ScalarTraits<T>;

  template <class Function>
  static Lanes each(Lanes a, const Function& f) {
    Lanes r;
    for (int i = 0; i < W; ++i)
      r.set(i, f(a[i]));
    return r;
  }
  template <class Function>
  static Mask ask(Lanes a, const Function& f) {
    std::uint32_t bits = 0;
    for (int i = 0; i < W; ++i)
      bits |= (f(a[i]) ? 1U : 0U) << i;
    return Mask::from_bits(bits);
  }
  static Lanes fma(Lanes a, Lanes b, Lanes c) {
    Lanes r;
    for (int i = 0; i < W; ++i)
      r.set(i, One::fma(a[i], b[i], c[i]));
    return r;
  }
  static Lanes sqrt(Lanes x) { return each(x, One::sqrt); }
  static Lanes abs(Lanes x) { return each(x, One::abs); }
  static Lanes floor(Lanes x) { return each(x, One::floor); }
  static Mask is_finite(Lanes x) { return ask(x, One::is_finite); }
  static Mask is_nan(Lanes x) { return ask(x, One::is_nan); }
  static Mask sign_bit(Lanes x) { return ask(x, One::sign_bit); }
  static constexpr T infinity() { return One::infinity(); }
  static constexpr T unit_roundoff() { return One::unit_roundoff(); }
  static constexpr T pi() { return One::pi(); }
};

}  // namespace alhazen
