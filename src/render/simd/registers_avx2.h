// render/simd: 16 and 32 bytes with AVX2 and FMA, which AVX-512 has too.
#pragma once

#include "render/simd/intrinsics.h"
#include "render/simd/vector_types.h"

namespace alhazen::render::registers {

template <class T, int W>
inline constexpr int kBytesOf = static_cast<int>(sizeof(T)) * W;
template <class T, int W>
concept InAvx2 = kBytesOf<T, W>
<= 32;

template <class T, int W>
requires InAvx2<T, W>
inline Vector<T, W> fma(Vector<T, W> a, Vector<T, W> b, Vector<T, W> c) {
  if constexpr (sizeof(T) == 8 && W == 2) return _mm_fmadd_pd(a, b, c);
  if constexpr (sizeof(T) == 8 && W == 4) return _mm256_fmadd_pd(a, b, c);
  if constexpr (sizeof(T) == 4 && W == 4) return _mm_fmadd_ps(a, b, c);
  if constexpr (sizeof(T) == 4 && W == 8) return _mm256_fmadd_ps(a, b, c);
}
template <class T, int W>
requires InAvx2<T, W>
inline Vector<T, W> sqrt(Vector<T, W> x) {
  if constexpr (sizeof(T) == 8 && W == 2) return _mm_sqrt_pd(x);
  if constexpr (sizeof(T) == 8 && W == 4) return _mm256_sqrt_pd(x);
  if constexpr (sizeof(T) == 4 && W == 4) return _mm_sqrt_ps(x);
  if constexpr (sizeof(T) == 4 && W == 8) return _mm256_sqrt_ps(x);
}
template <class T, int W>
requires InAvx2<T, W>
inline Vector<T, W> floor(Vector<T, W> x) {
  if constexpr (sizeof(T) == 8 && W == 2) return _mm_floor_pd(x);
  if constexpr (sizeof(T) == 8 && W == 4) return _mm256_floor_pd(x);
  if constexpr (sizeof(T) == 4 && W == 4) return _mm_floor_ps(x);
  if constexpr (sizeof(T) == 4 && W == 8) return _mm256_floor_ps(x);
}
template <class T, int W>
requires InAvx2<T, W>
inline Vector<T, W> least(Vector<T, W> a, Vector<T, W> b) {  // a < b ? a : b
  if constexpr (sizeof(T) == 8 && W == 2) return _mm_min_pd(a, b);
  if constexpr (sizeof(T) == 8 && W == 4) return _mm256_min_pd(a, b);
  if constexpr (sizeof(T) == 4 && W == 4) return _mm_min_ps(a, b);
  if constexpr (sizeof(T) == 4 && W == 8) return _mm256_min_ps(a, b);
}
template <class T, int W>
requires InAvx2<T, W>
inline Vector<T, W> greatest(Vector<T, W> a, Vector<T, W> b) {  // a > b ? a : b
  if constexpr (sizeof(T) == 8 && W == 2) return _mm_max_pd(a, b);
  if constexpr (sizeof(T) == 8 && W == 4) return _mm256_max_pd(a, b);
  if constexpr (sizeof(T) == 4 && W == 4) return _mm_max_ps(a, b);
  if constexpr (sizeof(T) == 4 && W == 8) return _mm256_max_ps(a, b);
}

}  // namespace alhazen::render::registers
