// render/simd: numbers side by side, one for each ray (or shape, or box) that is worked on at once.
//
// Lanes<T, W> is used like a T: kernels are templates on `Real`, and Real may be float, double,
// Quad or lanes of them. Each lane does exactly what a T would do, so a picture's bits do not
// depend on W. A comparison gives a LaneMask in the place of a bool; where a kernel for single
// numbers would branch, it selects (docs/lanes.md).
//
// The lanes are kept in registers of the instruction set that the file is compiled for
// (lane_form.h); all intrinsics stand in this folder.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/math/scalar.h"
#include "render/simd/lane_mask.h"

namespace alhazen::render {

template <class T, int W>
struct Lanes {
  using Scalar = T;
  using Mask = LaneMask<kMaskBytes<T>, W>;
  using Store = LaneStore<T, W>;
  using Value = typename Store::Value;
  static constexpr int kWidth = W;
  static constexpr Form kForm = form_of(static_cast<int>(sizeof(T)), W);

  Value value;

  Lanes() : value(Store::broadcast(T{})) {}
  // The same number in every lane. Literals and constants of any arithmetic type are welcome.
  template <class U>
  requires std::is_arithmetic_v<U> || std::same_as<U, T> Lanes(U one)
      : value(Store::broadcast(static_cast<T>(one))) {}
  // Each lane as static_cast<T> converts it.
  template <class U>
  requires(!std::same_as<U, T>) explicit Lanes(const Lanes<U, W>& other) : Lanes() {
    if constexpr (kForm == Form::vector && Lanes<U, W>::kForm == Form::vector) {
      value = __builtin_convertvector(other.value, Value);
    } else if constexpr (kForm == Form::pair || Lanes<U, W>::kForm == Form::pair) {
      *this = joined(Lanes<T, W / 2>(other.low()), Lanes<T, W / 2>(other.high()));
    } else {
      for (int i = 0; i < W; ++i)
        set(i, static_cast<T>(other[i]));
    }
  }
  static Lanes from_value(const Value& value) {
    Lanes result;
    result.value = value;
    return result;
  }

  T operator[](int i) const { return Store::get(value, i); }
  void set(int i, T one) { Store::put(value, i, one); }

  // The lanes below W/2, the others, and both again.
  Lanes<T, W / 2> low() const { return part<0>(); }
  Lanes<T, W / 2> high() const { return part<W / 2>(); }
  static Lanes joined(const Lanes<T, W / 2>& low, const Lanes<T, W / 2>& high) {
    if constexpr (kForm == Form::pair) {
      return from_value({low.value, high.value});
    } else if constexpr (Lanes<T, W / 2>::kForm == Form::vector) {
      return from_value(joined_vectors<T, W / 2>(low.value, high.value));
    } else {
      T numbers[W];
      low.store(numbers);
      high.store(numbers + W / 2);
      return load(numbers);
    }
  }

  // W numbers from memory, of any alignment, and back.
  static Lanes load(const T* from) { return from_value(Store::load(from)); }
  void store(T* to) const { Store::store(value, to); }
  // Stores the lanes of the mask one after the other, in order; how many there were. There must be
  // room for W.
  int store_compressed(Mask which, T* to) const {
    return Store::store_compressed(value, which.value, to);
  }
  // base[index[i]]; lanes outside of the mask are not read and are 0. An index of 32 bits has a
  // sign, or T has 64 bits.
  template <class Index>
  static Lanes gather(const T* base, const Lanes<Index, W>& index, Mask which = true) {
    if constexpr (kForm != Form::array && sizeof(Index) <= sizeof(T)) {
      return from_value(Store::gather(base, Lanes<WordOf<T>, W>(index).value, which.value));
    } else {
      Lanes result;
      for_each_lane(which, [&](int i) { result.set(i, base[index[i]]); });
      return result;
    }
  }
  // 0, 1, ... W - 1.
  static Lanes iota() { return from_value(Store::iota()); }

#define ALHAZEN_LANES_OPERATOR(op, where)                               \
  friend Lanes operator op(Lanes a, Lanes b) requires(where) {          \
    const auto f = [](const auto& p, const auto& q) { return p op q; }; \
    return from_value(Store::map(f, a.value, b.value));                 \
  }                                                                     \
  friend Lanes& operator op##=(Lanes& a, Lanes b) requires(where) {     \
    return a = a op b;                                                  \
  }
  ALHAZEN_LANES_OPERATOR(+, true)
  ALHAZEN_LANES_OPERATOR(-, true)
  ALHAZEN_LANES_OPERATOR(*, true)
  ALHAZEN_LANES_OPERATOR(/, !std::is_integral_v<T>)
  ALHAZEN_LANES_OPERATOR(&, std::is_integral_v<T>)
  ALHAZEN_LANES_OPERATOR(|, std::is_integral_v<T>)
  ALHAZEN_LANES_OPERATOR(^, std::is_integral_v<T>)
#undef ALHAZEN_LANES_OPERATOR
  friend Lanes operator-(Lanes a) {
    return from_value(Store::map([](const auto& p) { return -p; }, a.value));
  }
  friend Lanes operator<<(Lanes a, int by) requires std::is_integral_v<T> {
    return from_value(Store::shifted_up(a.value, by));
  }
  friend Lanes operator>>(Lanes a, int by) requires std::is_integral_v<T> {
    return from_value(Store::shifted_down(a.value, by));
  }

#define ALHAZEN_LANES_COMPARISON(op, name)                                                \
  friend Mask operator op(Lanes a, Lanes b) {                                             \
    return Mask::from_value(Store::template compare<Comparison::name>(a.value, b.value)); \
  }
  ALHAZEN_LANES_COMPARISON(==, equal)
  ALHAZEN_LANES_COMPARISON(!=, unequal)
  ALHAZEN_LANES_COMPARISON(<, less)
  ALHAZEN_LANES_COMPARISON(<=, less_equal)
  ALHAZEN_LANES_COMPARISON(>, greater)
  ALHAZEN_LANES_COMPARISON(>=, greater_equal)
#undef ALHAZEN_LANES_COMPARISON

 private:
  template <int kFirst>
  Lanes<T, W / 2> part() const {
    using Half = Lanes<T, W / 2>;
    if constexpr (kForm == Form::pair) {
      return Half::from_value(kFirst == 0 ? value.low : value.high);
    } else if constexpr (Half::kForm == Form::vector) {
      return Half::from_value(part_of_vector<T, W, W / 2, kFirst>(value));
    } else {
      T numbers[W];
      store(numbers);
      return Half::load(numbers + kFirst);
    }
  }
};

// yes where the mask is set, no elsewhere.
template <class T, int W>
inline Lanes<T, W> select(typename Lanes<T, W>::Mask mask, Lanes<T, W> yes, Lanes<T, W> no) {
  return Lanes<T, W>::from_value(Lanes<T, W>::Store::blend(mask.value, yes.value, no.value));
}
// In one instruction what alhazen::smaller and larger say with two.
template <std::floating_point T, int W>
inline Lanes<T, W> smaller(Lanes<T, W> a, Lanes<T, W> b) {
  return Lanes<T, W>::from_value(Lanes<T, W>::Store::smaller(a.value, b.value));
}
template <std::floating_point T, int W>
inline Lanes<T, W> larger(Lanes<T, W> a, Lanes<T, W> b) {
  return Lanes<T, W>::from_value(Lanes<T, W>::Store::larger(a.value, b.value));
}

// The least and the greatest of all lanes; none is NaN.
template <std::floating_point T, int W>
inline T least_of(const Lanes<T, W>& x) {
  if constexpr (W == 1) {
    return x[0];
  } else {
    return least_of(smaller(x.low(), x.high()));
  }
}
template <std::floating_point T, int W>
inline T greatest_of(const Lanes<T, W>& x) {
  if constexpr (W == 1) {
    return x[0];
  } else {
    return greatest_of(larger(x.low(), x.high()));
  }
}

// The same names for one number, whose answers are bools.
using alhazen::all;
using alhazen::any;
using alhazen::larger;
using alhazen::select;
using alhazen::smaller;

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
  using Store = typename Lanes::Store;
  using Mask = typename Lanes::Mask;
  using One = ScalarTraits<T>;

  static Lanes fma(Lanes a, Lanes b, Lanes c) {
    return Lanes::from_value(Store::fma(a.value, b.value, c.value));
  }
  static Lanes sqrt(Lanes x) { return Lanes::from_value(Store::sqrt(x.value)); }
  static Lanes abs(Lanes x) { return Lanes::from_value(Store::abs(x.value)); }
  static Lanes floor(Lanes x) { return Lanes::from_value(Store::floor(x.value)); }
  static Mask is_finite(Lanes x) { return abs(x) < Lanes(One::infinity()); }
  static Mask is_nan(Lanes x) { return x != x; }
  static Mask sign_bit(Lanes x) { return Mask::from_value(Store::sign_bit(x.value)); }
  static constexpr T infinity() { return One::infinity(); }
  static constexpr T unit_roundoff() { return One::unit_roundoff(); }
  static constexpr T pi() { return One::pi(); }
};

}  // namespace alhazen
