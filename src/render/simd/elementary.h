// render/simd: the elementary functions of core/math/elementary.h on lanes: each lane gives the
// bits of a single number.
#pragma once

#include "core/math/arc_kernels.h"
#include "core/math/circular_kernels.h"
#include "core/math/elementary.h"
#include "core/math/exp_log_kernels.h"
#include "render/simd/lane_bits.h"

namespace alhazen::render {

// f in double on either half of the lanes of float, rounded once.
template <int W, class Function, class... Floats>
inline Lanes<float, W> in_double(const Function& f, const Floats&... x) {
  if constexpr (W == 1) {
    return Lanes<float, W>(f(Lanes<double, W>(x)...));
  } else {
    using Half = Lanes<double, W / 2>;
    return Lanes<float, W>::joined(Lanes<float, W / 2>(f(Half(x.low())...)),
                                   Lanes<float, W / 2>(f(Half(x.high())...)));
  }
}

// Each function of T; what has no kernel (Quad) goes lane by lane.
template <class T, int W, class Kernel, class One, class... Rest>
inline Lanes<T, W> on_lanes(const Kernel& kernel_on, const One& one, Lanes<T, W> x, Rest... rest) {
  if constexpr (std::same_as<T, double>) {
    return kernel_on(x, rest...);
  } else if constexpr (std::same_as<T, float>) {
    return in_double<W>(kernel_on, x, rest...);
  } else {
    Lanes<T, W> result;
    for (int i = 0; i < W; ++i)
      result.set(i, one(x[i], rest[i]...));
    return result;
  }
}

#define ALHAZEN_ON_LANES_OF_ONE(name)                            \
  template <class T, int W>                                      \
  inline Lanes<T, W> name(Lanes<T, W> x) {                       \
    return on_lanes([](auto a) { return kernel::name(a); },      \
                    [](auto a) { return alhazen::name(a); }, x); \
  }                                                              \
  using alhazen::name;
#define ALHAZEN_ON_LANES_OF_TWO(name)                                           \
  template <class T, int W>                                                     \
  inline Lanes<T, W> name(Lanes<T, W> x, std::type_identity_t<Lanes<T, W>> y) { \
    return on_lanes([](auto a, auto b) { return kernel::name(a, b); },          \
                    [](auto a, auto b) { return alhazen::name(a, b); }, x, y);  \
  }                                                                             \
  using alhazen::name;
ALHAZEN_ON_LANES_OF_ONE(exp_of)
ALHAZEN_ON_LANES_OF_ONE(log_of)
ALHAZEN_ON_LANES_OF_ONE(acos_turns)
ALHAZEN_ON_LANES_OF_TWO(power)
ALHAZEN_ON_LANES_OF_TWO(atan2_turns)
#undef ALHAZEN_ON_LANES_OF_ONE
#undef ALHAZEN_ON_LANES_OF_TWO

using alhazen::sin_cos_of_turns;
template <class T, int W>
inline SinCos<Lanes<T, W>> sin_cos_of_turns(Lanes<T, W> u) {
  SinCos<Lanes<T, W>> result;
  if constexpr (std::same_as<T, double>) {
    result = kernel::sin_cos_of_turns(u);
  } else if constexpr (std::same_as<T, float> && W > 1) {
    const auto low = kernel::sin_cos_of_turns(Lanes<double, W / 2>(u.low())),
               high = kernel::sin_cos_of_turns(Lanes<double, W / 2>(u.high()));
    using Half = Lanes<float, W / 2>;
    result = {Lanes<T, W>::joined(Half(low.sin), Half(high.sin)),
              Lanes<T, W>::joined(Half(low.cos), Half(high.cos))};
  } else {
    for (int i = 0; i < W; ++i) {
      const SinCos<T> one = alhazen::sin_cos_of_turns(u[i]);
      result.sin.set(i, one.sin);
      result.cos.set(i, one.cos);
    }
  }
  return result;
}

}  // namespace alhazen::render
