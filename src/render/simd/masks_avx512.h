// render/simd: masks of AVX-512: a bit a lane, for registers of 16, 32 and 64 bytes.
#pragma once

#include <concepts>

#include "render/simd/lane_form.h"
#include "render/simd/registers_avx512.h"

namespace alhazen::render {

template <int Bytes, int W>
struct MaskStore<Bytes, W, Form::vector> {
  using Value = std::conditional_t<W == 16, __mmask16, __mmask8>;  // bits from W on are 0

  static Value all_of(bool answer) { return static_cast<Value>(answer ? low_bits(W) : 0); }
  static Value from_bits(std::uint32_t bits) { return static_cast<Value>(bits & low_bits(W)); }
  static std::uint32_t bits(Value mask) { return mask; }
  static Value both(Value a, Value b) { return static_cast<Value>(a & b); }
  static Value either(Value a, Value b) { return static_cast<Value>(a | b); }
  static Value differing(Value a, Value b) { return static_cast<Value>(a ^ b); }
};

namespace registers {

template <class T, int W>
using MaskFor = typename MaskStore<static_cast<int>(sizeof(T)), W>::Value;

template <Comparison C, bool real>
constexpr int predicate() {
  if (C == Comparison::equal) return real ? _CMP_EQ_OQ : _MM_CMPINT_EQ;
  if (C == Comparison::unequal) return real ? _CMP_NEQ_UQ : _MM_CMPINT_NE;
  if (C == Comparison::less) return real ? _CMP_LT_OS : _MM_CMPINT_LT;
  if (C == Comparison::less_equal) return real ? _CMP_LE_OS : _MM_CMPINT_LE;
  if (C == Comparison::greater) return real ? _CMP_GT_OS : _MM_CMPINT_NLE;
  return real ? _CMP_GE_OS : _MM_CMPINT_NLT;
}

template <class T, int W>
using Signed = Vector<WordOf<T>, W>;

template <Comparison C, class T, int W>
inline MaskFor<T, W> compare(Vector<T, W> a, Vector<T, W> b) {
  constexpr int kBytes = kBytesOf<T, W>;
  constexpr int kHow = predicate<C, std::is_floating_point_v<T>>();
  if constexpr (std::same_as<T, double>) {
    if constexpr (kBytes == 16) return _mm_cmp_pd_mask(a, b, kHow);
    if constexpr (kBytes == 32) return _mm256_cmp_pd_mask(a, b, kHow);
    if constexpr (kBytes == 64) return _mm512_cmp_pd_mask(a, b, kHow);
  } else if constexpr (std::same_as<T, float>) {
    if constexpr (kBytes == 16) return _mm_cmp_ps_mask(a, b, kHow);
    if constexpr (kBytes == 32) return _mm256_cmp_ps_mask(a, b, kHow);
    if constexpr (kBytes == 64) return _mm512_cmp_ps_mask(a, b, kHow);
  } else {
    using Bits = Vector<long long, kBytes / 8>;
    const Bits p = vector_bits<Bits>(a), q = vector_bits<Bits>(b);
    constexpr bool kSigned = std::is_signed_v<T>;
    if constexpr (sizeof(T) == 8 && kSigned) {
      if constexpr (kBytes == 16) return _mm_cmp_epi64_mask(p, q, kHow);
      if constexpr (kBytes == 32) return _mm256_cmp_epi64_mask(p, q, kHow);
      if constexpr (kBytes == 64) return _mm512_cmp_epi64_mask(p, q, kHow);
    } else if constexpr (sizeof(T) == 8) {
      if constexpr (kBytes == 16) return _mm_cmp_epu64_mask(p, q, kHow);
      if constexpr (kBytes == 32) return _mm256_cmp_epu64_mask(p, q, kHow);
      if constexpr (kBytes == 64) return _mm512_cmp_epu64_mask(p, q, kHow);
    } else if constexpr (kSigned) {
      if constexpr (kBytes == 16) return _mm_cmp_epi32_mask(p, q, kHow);
      if constexpr (kBytes == 32) return _mm256_cmp_epi32_mask(p, q, kHow);
      if constexpr (kBytes == 64) return _mm512_cmp_epi32_mask(p, q, kHow);
    } else {
      if constexpr (kBytes == 16) return _mm_cmp_epu32_mask(p, q, kHow);
      if constexpr (kBytes == 32) return _mm256_cmp_epu32_mask(p, q, kHow);
      if constexpr (kBytes == 64) return _mm512_cmp_epu32_mask(p, q, kHow);
    }
  }
}

// What follows treats numbers as bits, by their size alone.
template <class T, int W>
inline MaskFor<T, W> signs(Vector<T, W> x) {
  return compare<Comparison::less, WordOf<T>, W>(vector_bits<Words<T, W>>(x), Words<T, W>{});
}

template <class T, int W>
inline Vector<T, W> blend(MaskFor<T, W> mask, Vector<T, W> yes, Vector<T, W> no) {
  constexpr int kBytes = kBytesOf<T, W>;
  const auto as = [](auto v) { return vector_bits<Vector<T, W>>(v); };
  if constexpr (sizeof(T) == 8) {
    if constexpr (kBytes == 16)
      return as(_mm_mask_blend_pd(mask, vector_bits<__m128d>(no), vector_bits<__m128d>(yes)));
    if constexpr (kBytes == 32)
      return as(_mm256_mask_blend_pd(mask, vector_bits<__m256d>(no), vector_bits<__m256d>(yes)));
    if constexpr (kBytes == 64)
      return as(_mm512_mask_blend_pd(mask, vector_bits<__m512d>(no), vector_bits<__m512d>(yes)));
  } else {
    if constexpr (kBytes == 16)
      return as(_mm_mask_blend_ps(mask, vector_bits<__m128>(no), vector_bits<__m128>(yes)));
    if constexpr (kBytes == 32)
      return as(_mm256_mask_blend_ps(mask, vector_bits<__m256>(no), vector_bits<__m256>(yes)));
    if constexpr (kBytes == 64)
      return as(_mm512_mask_blend_ps(mask, vector_bits<__m512>(no), vector_bits<__m512>(yes)));
  }
}

// base[index[i]] where the mask is set, 0 elsewhere.
template <class T, int W>
inline Vector<T, W> gather(const T* base, Words<T, W> index, MaskFor<T, W> mask) {
  constexpr int kBytes = kBytesOf<T, W>;
  const auto as = [](auto v) { return vector_bits<Vector<T, W>>(v); };
  if constexpr (sizeof(T) == 8) {
    if constexpr (kBytes == 16)
      return as(
          _mm_mmask_i64gather_pd(_mm_setzero_pd(), mask, vector_bits<__m128i>(index), base, 8));
    if constexpr (kBytes == 32)
      return as(_mm256_mmask_i64gather_pd(_mm256_setzero_pd(), mask, vector_bits<__m256i>(index),
                                          base, 8));
    if constexpr (kBytes == 64)
      return as(_mm512_mask_i64gather_pd(_mm512_setzero_pd(), mask, vector_bits<__m512i>(index),
                                         base, 8));
  } else {
    if constexpr (kBytes == 16)
      return as(
          _mm_mmask_i32gather_ps(_mm_setzero_ps(), mask, vector_bits<__m128i>(index), base, 4));
    if constexpr (kBytes == 32)
      return as(_mm256_mmask_i32gather_ps(_mm256_setzero_ps(), mask, vector_bits<__m256i>(index),
                                          base, 4));
    if constexpr (kBytes == 64)
      return as(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), mask, vector_bits<__m512i>(index),
                                         base, 4));
  }
}

// Packs the lanes in the register and writes it whole: compressing stores are slow on some
// machines.
template <class T, int W>
inline int store_compressed(Vector<T, W> v, MaskFor<T, W> which, T* to) {
  constexpr int kBytes = kBytesOf<T, W>;
  const auto put = [to](auto packed) { __builtin_memcpy(to, &packed, sizeof(packed)); };
  if constexpr (sizeof(T) == 8) {
    if constexpr (kBytes == 16) put(_mm_maskz_compress_epi64(which, vector_bits<__m128i>(v)));
    if constexpr (kBytes == 32) put(_mm256_maskz_compress_epi64(which, vector_bits<__m256i>(v)));
    if constexpr (kBytes == 64) put(_mm512_maskz_compress_epi64(which, vector_bits<__m512i>(v)));
  } else {
    if constexpr (kBytes == 16) put(_mm_maskz_compress_epi32(which, vector_bits<__m128i>(v)));
    if constexpr (kBytes == 32) put(_mm256_maskz_compress_epi32(which, vector_bits<__m256i>(v)));
    if constexpr (kBytes == 64) put(_mm512_maskz_compress_epi32(which, vector_bits<__m512i>(v)));
  }
  return __builtin_popcount(which);
}

}  // namespace registers
}  // namespace alhazen::render
