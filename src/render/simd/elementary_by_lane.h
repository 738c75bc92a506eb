// render/simd: elementary functions of lanes, one lane after the other.
#pragma once

#include "core/math/elementary.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

using alhazen::acos_turns;
using alhazen::atan2_turns;
using alhazen::exp_of;
using alhazen::log_of;
using alhazen::power;
using alhazen::sin_cos_of_turns;

template <class T, int W>
inline Lanes<T, W> exp_of(Lanes<T, W> x) {
  Lanes<T, W> r;
  for (int i = 0; i < W; ++i)
    r.set(i, alhazen::exp_of(x[i]));
  return r;
}
template <class T, int W>
inline Lanes<T, W> power(Lanes<T, W> base, Lanes<T, W> exponent) {
  Lanes<T, W> r;
  for (int i = 0; i < W; ++i)
    r.set(i, alhazen::power(base[i], exponent[i]));
  return r;
}
template <class T, int W>
inline Lanes<T, W> atan2_turns(Lanes<T, W> y, Lanes<T, W> x) {
  Lanes<T, W> r;
  for (int i = 0; i < W; ++i)
    r.set(i, alhazen::atan2_turns(y[i], x[i]));
  return r;
}
template <class T, int W>
inline Lanes<T, W> acos_turns(Lanes<T, W> x) {
  Lanes<T, W> r;
  for (int i = 0; i < W; ++i)
    r.set(i, alhazen::acos_turns(x[i]));
  return r;
}
template <class T, int W>
inline SinCos<Lanes<T, W>> sin_cos_of_turns(Lanes<T, W> u) {
  SinCos<Lanes<T, W>> r;
  for (int i = 0; i < W; ++i) {
    const SinCos<T> one = alhazen::sin_cos_of_turns(u[i]);
    r.sin.set(i, one.sin);
    r.cos.set(i, one.cos);
  }
  return r;
}

}  // namespace alhazen::render
