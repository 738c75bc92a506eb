// render/simd: lanes as an array. What the compiler makes of a loop; every other form must give the
// same bits as this one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/math/scalar.h"
#include "render/simd/lane_form.h"

namespace alhazen::render {

template <int Bytes, int W>
struct MaskStore<Bytes, W, Form::array> {
  using Value = std::uint32_t;  // bit i is lane i; the others are 0

  static Value all_of(bool answer) { return answer ? low_bits(W) : 0; }
  static Value from_bits(std::uint32_t bits) { return bits & low_bits(W); }
  static std::uint32_t bits(Value mask) { return mask; }
  static Value both(Value a, Value b) { return a & b; }
  static Value either(Value a, Value b) { return a | b; }
  static Value differing(Value a, Value b) { return a ^ b; }
};

template <class T, int W>
struct LaneStore<T, W, Form::array> {
  using Value = std::array<T, W>;
  using Masks = MaskStore<kMaskBytes<T>, W>;
  using Mask = typename Masks::Value;
  using One = ScalarTraits<T>;

  template <class Function, class... Values>
  static Value map(const Function& f, const Values&... of) {
    Value result;
    for (std::size_t i = 0; i < W; ++i)
      result[i] = static_cast<T>(f(of[i]...));
    return result;
  }
  template <class Function, class... Values>
  static Mask ask(const Function& f, const Values&... of) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < W; ++i)
      bits |= (f(of[i]...) ? 1U : 0U) << i;
    return Masks::from_bits(bits);
  }

  static Value shifted_up(const Value& v, int by) {
    return map([by](T x) { return x << by; }, v);
  }
  static Value shifted_down(const Value& v, int by) {
    return map([by](T x) { return x >> by; }, v);
  }
  static Value broadcast(T x) {
    Value result;
    result.fill(x);
    return result;
  }
  static Value iota() {
    Value result;
    for (std::size_t i = 0; i < W; ++i)
      result[i] = static_cast<T>(static_cast<int>(i));
    return result;
  }
  static T get(const Value& v, int i) { return v[static_cast<std::size_t>(i)]; }
  static void put(Value& v, int i, T x) { v[static_cast<std::size_t>(i)] = x; }

  static Value load(const T* from) {
    Value result;
    for (std::size_t i = 0; i < W; ++i)
      result[i] = from[i];
    return result;
  }
  static void store(const Value& v, T* to) {
    for (std::size_t i = 0; i < W; ++i)
      to[i] = v[i];
  }
  static int store_compressed(const Value& v, const Mask& which, T* to) {
    const std::uint32_t bits = Masks::bits(which);
    int count = 0;
    for (std::size_t i = 0; i < W; ++i) {
      if (((bits >> i) & 1U) != 0) to[count++] = v[i];
    }
    return count;
  }
  template <Comparison C>
  static Mask compare(const Value& a, const Value& b) {
    return ask(compared<C, T>, a, b);
  }
  static Value blend(const Mask& mask, const Value& yes, const Value& no) {
    const std::uint32_t bits = Masks::bits(mask);
    Value result;
    for (std::size_t i = 0; i < W; ++i)
      result[i] = ((bits >> i) & 1U) != 0 ? yes[i] : no[i];
    return result;
  }
  static Value smaller(const Value& a, const Value& b) { return map(alhazen::smaller<T>, a, b); }
  static Value larger(const Value& a, const Value& b) { return map(alhazen::larger<T>, a, b); }
  static Value fma(const Value& a, const Value& b, const Value& c) {
    return map(One::fma, a, b, c);
  }
  static Value sqrt(const Value& x) { return map(One::sqrt, x); }
  static Value abs(const Value& x) { return map(One::abs, x); }
  static Value floor(const Value& x) { return map(One::floor, x); }
  static Mask sign_bit(const Value& x) { return ask(One::sign_bit, x); }
};

}  // namespace alhazen::render
