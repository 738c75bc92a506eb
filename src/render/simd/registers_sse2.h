// render/simd: what the baseline of x86-64 has for 16 bytes, and what it has not.
#pragma once

#include "core/math/scalar.h"
#include "render/simd/intrinsics.h"
#include "render/simd/vector_types.h"

namespace alhazen::render::registers {

// The baseline has no fused product. The C library's is rounded once, as everywhere; a product and
// a sum would be rounded twice, and pictures would depend on the machine.
template <class T, int W>
inline Vector<T, W> fma(Vector<T, W> a, Vector<T, W> b, Vector<T, W> c) {
  Vector<T, W> result{};
  for (int i = 0; i < W; ++i)
    result[i] = ScalarTraits<T>::fma(a[i], b[i], c[i]);
  return result;
}
template <class T, int W>
inline Vector<T, W> sqrt(Vector<T, W> x) {
  if constexpr (W == 2)
    return _mm_sqrt_pd(x);
  else
    return _mm_sqrt_ps(x);
}
template <class T, int W>
inline Vector<T, W> least(Vector<T, W> a, Vector<T, W> b) {  // a < b ? a : b
  if constexpr (W == 2)
    return _mm_min_pd(a, b);
  else
    return _mm_min_ps(a, b);
}
template <class T, int W>
inline Vector<T, W> greatest(Vector<T, W> a, Vector<T, W> b) {  // a > b ? a : b
  if constexpr (W == 2)
    return _mm_max_pd(a, b);
  else
    return _mm_max_ps(a, b);
}

template <class Word, int W>
inline std::uint32_t bits_of_signs(Vector<Word, W> x) {
  if constexpr (W == 2)
    return static_cast<std::uint32_t>(_mm_movemask_pd(vector_bits<__m128d>(x)));
  else
    return static_cast<std::uint32_t>(_mm_movemask_ps(vector_bits<__m128>(x)));
}

// Each lane of the mask is all ones or all zeros.
template <class T, int W>
inline Vector<T, W> blend(Words<T, W> mask, Vector<T, W> yes, Vector<T, W> no) {
  using Bits = Words<T, W>;
  return vector_bits<Vector<T, W>>((mask & vector_bits<Bits>(yes)) |
                                   (~mask & vector_bits<Bits>(no)));
}

// |x| + 2^52 has no digits after the point (2^23 for float): it rounds |x| to the nearest. One less
// where that went up; what has no such digits to begin with, and a NaN, stays as it is.
template <class T, int W>
inline Vector<T, W> floor(Vector<T, W> x) {
  using Bits = Words<T, W>;
  const Vector<T, W> whole = broadcast_vector<T, W>(sizeof(T) == 8 ? T(0x1p52) : T(0x1p23));
  const Vector<T, W> one = broadcast_vector<T, W>(T(1));
  const Bits sign = vector_bits<Bits>(broadcast_vector<T, W>(-T(0)));
  const Vector<T, W> size = vector_bits<Vector<T, W>>(vector_bits<Bits>(x) & ~sign);
  const Bits nearest = vector_bits<Bits>((size + whole) - whole) | (vector_bits<Bits>(x) & sign);
  const Vector<T, W> rounded = vector_bits<Vector<T, W>>(nearest);
  const Vector<T, W> below = blend<T, W>(rounded > x, rounded - one, rounded);
  return blend<T, W>(size < whole, below, x);
}

// base[index[i]] where the mask is set, 0 elsewhere.
template <class T, int W>
inline Vector<T, W> gather(const T* base, Words<T, W> index, Words<T, W> mask) {
  Vector<T, W> result{};
  for (int i = 0; i < W; ++i) {
    if (mask[i] != 0) result[i] = base[index[i]];
  }
  return result;
}

}  // namespace alhazen::render::registers
