// render/simd: 64 bytes with AVX-512.
#pragma once

#include "render/simd/registers_avx2.h"

namespace alhazen::render::registers {

template <class T, int W>
concept InAvx512 = kBytesOf<T, W>
== 64;

template <class T, int W>
requires InAvx512<T, W>
inline Vector<T, W> fma(Vector<T, W> a, Vector<T, W> b, Vector<T, W> c) {
  if constexpr (W == 8)
    return _mm512_fmadd_pd(a, b, c);
  else
    return _mm512_fmadd_ps(a, b, c);
}
template <class T, int W>
requires InAvx512<T, W>
inline Vector<T, W> sqrt(Vector<T, W> x) {
  if constexpr (W == 8)
    return _mm512_sqrt_pd(x);
  else
    return _mm512_sqrt_ps(x);
}
template <class T, int W>
requires InAvx512<T, W>
inline Vector<T, W> floor(Vector<T, W> x) {
  constexpr int kDown = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
  if constexpr (W == 8)
    return _mm512_roundscale_pd(x, kDown);
  else
    return _mm512_roundscale_ps(x, kDown);
}
template <class T, int W>
requires InAvx512<T, W>
inline Vector<T, W> least(Vector<T, W> a, Vector<T, W> b) {  // a < b ? a : b
  if constexpr (W == 8)
    return _mm512_min_pd(a, b);
  else
    return _mm512_min_ps(a, b);
}
template <class T, int W>
requires InAvx512<T, W>
inline Vector<T, W> greatest(Vector<T, W> a, Vector<T, W> b) {  // a > b ? a : b
  if constexpr (W == 8)
    return _mm512_max_pd(a, b);
  else
    return _mm512_max_ps(a, b);
}

}  // namespace alhazen::render::registers
