// render/simd: lanes as two halves, for widths that no register of the instruction set holds.
#pragma once

#include <cstdint>

#include "render/simd/lane_form.h"

namespace alhazen::render {

template <class Half>
struct HalvesOf {
  Half low, high;  // the lanes below W/2, and the others
};

template <int Bytes, int W>
struct MaskStore<Bytes, W, Form::pair> {
  using Half = MaskStore<Bytes, W / 2>;
  using Value = HalvesOf<typename Half::Value>;

  static Value all_of(bool answer) { return {Half::all_of(answer), Half::all_of(answer)}; }
  static Value from_bits(std::uint32_t bits) {
    return {Half::from_bits(bits & low_bits(W / 2)), Half::from_bits(bits >> (W / 2))};
  }
  static std::uint32_t bits(const Value& mask) {
    return Half::bits(mask.low) | Half::bits(mask.high) << (W / 2);
  }
  static Value both(const Value& a, const Value& b) {
    return {Half::both(a.low, b.low), Half::both(a.high, b.high)};
  }
  static Value either(const Value& a, const Value& b) {
    return {Half::either(a.low, b.low), Half::either(a.high, b.high)};
  }
  static Value differing(const Value& a, const Value& b) {
    return {Half::differing(a.low, b.low), Half::differing(a.high, b.high)};
  }
};

template <class T, int W>
struct LaneStore<T, W, Form::pair> {
  using Half = LaneStore<T, W / 2>;
  using Value = HalvesOf<typename Half::Value>;
  using Masks = MaskStore<static_cast<int>(sizeof(T)), W>;
  using Mask = typename Masks::Value;

  template <class Function, class... Values>
  static Value map(const Function& f, const Values&... of) {
    return {Half::map(f, of.low...), Half::map(f, of.high...)};
  }
  static Value shifted_up(const Value& v, int by) {
    return {Half::shifted_up(v.low, by), Half::shifted_up(v.high, by)};
  }
  static Value shifted_down(const Value& v, int by) {
    return {Half::shifted_down(v.low, by), Half::shifted_down(v.high, by)};
  }
  static Value broadcast(T x) { return {Half::broadcast(x), Half::broadcast(x)}; }
  static Value iota() {
    const auto low = Half::iota();
    const auto up = Half::broadcast(static_cast<T>(W / 2));
    return {low, Half::map([](const auto& a, const auto& b) { return a + b; }, low, up)};
  }
  static T get(const Value& v, int i) {
    return i < W / 2 ? Half::get(v.low, i) : Half::get(v.high, i - W / 2);
  }
  static void put(Value& v, int i, T x) {
    if (i < W / 2)
      Half::put(v.low, i, x);
    else
      Half::put(v.high, i - W / 2, x);
  }
  static Value load(const T* from) { return {Half::load(from), Half::load(from + W / 2)}; }
  static void store(const Value& v, T* to) {
    Half::store(v.low, to);
    Half::store(v.high, to + W / 2);
  }
  static int store_compressed(const Value& v, const Mask& which, T* to) {
    const int count = Half::store_compressed(v.low, which.low, to);
    return count + Half::store_compressed(v.high, which.high, to + count);
  }
  template <class Index>
  static Value gather(const T* base, const HalvesOf<Index>& index, const Mask& which) {
    return {Half::gather(base, index.low, which.low), Half::gather(base, index.high, which.high)};
  }

  template <Comparison C>
  static Mask compare(const Value& a, const Value& b) {
    return {Half::template compare<C>(a.low, b.low), Half::template compare<C>(a.high, b.high)};
  }
  static Value blend(const Mask& mask, const Value& yes, const Value& no) {
    return {Half::blend(mask.low, yes.low, no.low), Half::blend(mask.high, yes.high, no.high)};
  }
  static Value smaller(const Value& a, const Value& b) {
    return {Half::smaller(a.low, b.low), Half::smaller(a.high, b.high)};
  }
  static Value larger(const Value& a, const Value& b) {
    return {Half::larger(a.low, b.low), Half::larger(a.high, b.high)};
  }
  static Value fma(const Value& a, const Value& b, const Value& c) {
    return {Half::fma(a.low, b.low, c.low), Half::fma(a.high, b.high, c.high)};
  }
  static Value sqrt(const Value& x) { return {Half::sqrt(x.low), Half::sqrt(x.high)}; }
  static Value abs(const Value& x) { return {Half::abs(x.low), Half::abs(x.high)}; }
  static Value floor(const Value& x) { return {Half::floor(x.low), Half::floor(x.high)}; }
  static Mask sign_bit(const Value& x) { return {Half::sign_bit(x.low), Half::sign_bit(x.high)}; }
};

}  // namespace alhazen::render
