// render/simd: masks of SSE2 and AVX2: a register whose lanes are all ones or all zeros.
#pragma once

#include "render/simd/lane_form.h"
#include "render/simd/vector_types.h"

#if ALHAZEN_SIMD_AVX2
#include "render/simd/blend_avx2.h"
#include "render/simd/registers_avx2.h"
#else
#include "render/simd/registers_sse2.h"
#endif

namespace alhazen::render {

template <int Bytes, int W>
struct MaskStore<Bytes, W, Form::vector> {
  using Word = std::conditional_t<Bytes == 4, std::int32_t, std::int64_t>;
  using Value = Vector<Word, W>;

  static Value all_of(bool answer) { return broadcast_vector<Word, W>(answer ? -1 : 0); }
  static Value from_bits(std::uint32_t bits) {
    const Value one_each = broadcast_vector<Word, W>(1) << iota_vector<Word, W>();
    return (broadcast_vector<Word, W>(static_cast<Word>(bits)) & one_each) == one_each;
  }
  static std::uint32_t bits(Value mask) { return registers::bits_of_signs<Word, W>(mask); }
  static Value both(Value a, Value b) { return a & b; }
  static Value either(Value a, Value b) { return a | b; }
  static Value differing(Value a, Value b) { return a ^ b; }
};

namespace registers {

template <class T, int W>
using MaskFor = Words<T, W>;

template <Comparison C, class T, int W>
inline MaskFor<T, W> compare(Vector<T, W> a, Vector<T, W> b) {
  return vector_bits<MaskFor<T, W>>(compared<C, Vector<T, W>>(a, b));
}

template <class T, int W>
inline MaskFor<T, W> signs(Vector<T, W> x) {
  return vector_bits<MaskFor<T, W>>(vector_bits<Words<T, W>>(x) < Words<T, W>{});
}

// Writes every lane and moves on after those that are wanted: no branch to mispredict.
template <class T, int W>
inline int store_compressed(Vector<T, W> v, MaskFor<T, W> which, T* to) {
  const std::uint32_t bits = bits_of_signs<WordOf<T>, W>(which);
  int count = 0;
  for (int i = 0; i < W; ++i) {
    to[count] = v[i];
    count += static_cast<int>((bits >> i) & 1U);
  }
  return count;
}

}  // namespace registers
}  // namespace alhazen::render
