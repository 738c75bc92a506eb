// render/simd: lanes as one register.
#pragma once

#include "render/simd/lane_form.h"
#include "render/simd/vector_types.h"

#if ALHAZEN_SIMD_AVX512
#include "render/simd/masks_avx512.h"
#else
#include "render/simd/masks_vector.h"
#endif

namespace alhazen::render {

template <class T, int W>
struct LaneStore<T, W, Form::vector> {
  using Value = Vector<T, W>;
  using Masks = MaskStore<static_cast<int>(sizeof(T)), W>;
  using Mask = typename Masks::Value;
  using Bits = Words<T, W>;

  template <class Function, class... Values>
  static Value map(const Function& f, Values... of) {
    return f(of...);
  }
  static Value shifted_up(Value v, int by) { return v << broadcast(static_cast<T>(by)); }
  static Value shifted_down(Value v, int by) { return v >> broadcast(static_cast<T>(by)); }
  static Value broadcast(T x) { return broadcast_vector<T, W>(x); }
  static Value iota() { return iota_vector<T, W>(); }
  static T get(Value v, int i) { return v[i]; }
  static void put(Value& v, int i, T x) {
    // Not v[i] = x: g++ 12 then warns that lanes which are all put one by one are uninitialised.
    __builtin_memcpy(reinterpret_cast<char*>(&v) + static_cast<int>(sizeof(T)) * i, &x, sizeof(T));
  }

  static Value load(const T* from) {
    Value result;
    __builtin_memcpy(&result, from, sizeof(result));
    return result;
  }
  static void store(Value v, T* to) { __builtin_memcpy(to, &v, sizeof(v)); }
  static int store_compressed(Value v, Mask which, T* to) {
    return registers::store_compressed<T, W>(v, which, to);
  }
  static Value gather(const T* base, Bits index, Mask which) {
    return registers::gather<T, W>(base, index, which);
  }

  template <Comparison C>
  static Mask compare(Value a, Value b) {
    return registers::compare<C, T, W>(a, b);
  }
  static Value blend(Mask mask, Value yes, Value no) {
    return registers::blend<T, W>(mask, yes, no);
  }
  // As alhazen::smaller and larger do with zeros and NaNs.
  static Value smaller(Value a, Value b) { return registers::least<T, W>(b, a); }
  static Value larger(Value a, Value b) { return registers::greatest<T, W>(b, a); }
  static Value fma(Value a, Value b, Value c) { return registers::fma<T, W>(a, b, c); }
  static Value sqrt(Value x) { return registers::sqrt<T, W>(x); }
  static Value floor(Value x) { return registers::floor<T, W>(x); }
  static Value abs(Value x) {
    return vector_bits<Value>(vector_bits<Bits>(x) & ~vector_bits<Bits>(broadcast(-T(0))));
  }
  static Mask sign_bit(Value x) { return registers::signs<T, W>(x); }
};

}  // namespace alhazen::render
