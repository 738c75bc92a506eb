// render/simd: AVX2 by masks that are registers: choosing, gathering.
#pragma once

#include "render/simd/registers_avx2.h"

namespace alhazen::render::registers {

template <class Word, int W>
inline std::uint32_t bits_of_signs(Vector<Word, W> x) {
  int bits = 0;
  if constexpr (sizeof(Word) == 8 && W == 2) bits = _mm_movemask_pd(vector_bits<__m128d>(x));
  if constexpr (sizeof(Word) == 8 && W == 4) bits = _mm256_movemask_pd(vector_bits<__m256d>(x));
  if constexpr (sizeof(Word) == 4 && W == 4) bits = _mm_movemask_ps(vector_bits<__m128>(x));
  if constexpr (sizeof(Word) == 4 && W == 8) bits = _mm256_movemask_ps(vector_bits<__m256>(x));
  return static_cast<std::uint32_t>(bits);
}

template <class T, int W>
inline Vector<T, W> blend(Words<T, W> mask, Vector<T, W> yes, Vector<T, W> no) {
  const auto chosen = [&]<class V>(V m, V a, V b) {
    if constexpr (sizeof(T) == 8 && W == 2) return _mm_blendv_pd(b, a, m);
    if constexpr (sizeof(T) == 8 && W == 4) return _mm256_blendv_pd(b, a, m);
    if constexpr (sizeof(T) == 4 && W == 4) return _mm_blendv_ps(b, a, m);
    if constexpr (sizeof(T) == 4 && W == 8) return _mm256_blendv_ps(b, a, m);
  };
  using Real = Vector<std::conditional_t<sizeof(T) == 4, float, double>, W>;
  return vector_bits<Vector<T, W>>(
      chosen(vector_bits<Real>(mask), vector_bits<Real>(yes), vector_bits<Real>(no)));
}

// base[index[i]] where the mask is set, 0 elsewhere.
template <class T, int W>
inline Vector<T, W> gather(const T* base, Words<T, W> index, Words<T, W> mask) {
  if constexpr (sizeof(T) == 8) {
    const double* from = reinterpret_cast<const double*>(base);
    if constexpr (W == 2)
      return vector_bits<Vector<T, W>>(_mm_mask_i64gather_pd(
          _mm_setzero_pd(), from, vector_bits<__m128i>(index), vector_bits<__m128d>(mask), 8));
    else
      return vector_bits<Vector<T, W>>(_mm256_mask_i64gather_pd(
          _mm256_setzero_pd(), from, vector_bits<__m256i>(index), vector_bits<__m256d>(mask), 8));
  } else {
    const float* from = reinterpret_cast<const float*>(base);
    if constexpr (W == 4)
      return vector_bits<Vector<T, W>>(_mm_mask_i32gather_ps(
          _mm_setzero_ps(), from, vector_bits<__m128i>(index), vector_bits<__m128>(mask), 4));
    else
      return vector_bits<Vector<T, W>>(_mm256_mask_i32gather_ps(
          _mm256_setzero_ps(), from, vector_bits<__m256i>(index), vector_bits<__m256>(mask), 4));
  }
}

}  // namespace alhazen::render::registers
