// render/shape: from kernels of numbers to kernels of other numbers. Each kernel lists its fields
// once (`fields`); this walks over them down to single numbers and flags.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>

#include "core/math/vec.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// Calls set(number of `to`, number of `from`) for each number and each flag.
template <class To, class From, class Set>
inline void for_each_field(To& to, const From& from, const Set& set) {
  if constexpr (requires { To::fields(to); }) {
    const auto into = To::fields(to);
    const auto out_of = From::fields(from);
    const auto pair_up = [&]<std::size_t... i>(std::index_sequence<i...>) {
      (for_each_field(std::get<i>(into), std::get<i>(out_of), set), ...);
    };
    pair_up(std::make_index_sequence<std::tuple_size_v<decltype(To::fields(to))>>());
  } else if constexpr (requires { to.x; }) {
    for_each_field(to.x, from.x, set);
    for_each_field(to.y, from.y, set);
    for_each_field(to.z, from.z, set);
  } else if constexpr (requires { std::tuple_size<To>::value; }) {
    for (std::size_t i = 0; i < to.size(); ++i)
      for_each_field(to[i], from[i], set);
  } else {
    set(to, from);
  }
}

// The same kernel in another scalar type, or once in each lane.
template <class Real, template <class> class Kernel, class Other>
requires(!std::same_as<Real, Other>) inline Kernel<Real> convert(const Kernel<Other>& kernel) {
  Kernel<Real> result;
  for_each_field(result, kernel, []<class To, class From>(To& to, const From& from) {
    to = static_cast<To>(from);
  });
  return result;
}
template <class Real, template <class> class Kernel>
inline const Kernel<Real>& convert(const Kernel<Real>& kernel) {
  return kernel;
}

// In each lane of `which` the kernel first[index[lane]]; the others have no meaning. A number is
// gathered as what stands index * stride after the same number of the first kernel, which has to
// be in the range of IntOf<L>.
template <class L, template <class> class Kernel>
inline Kernel<L> gathered_kernel(const Kernel<ScalarOf<L>>* first, const IntOf<L>& index,
                                 const MaskOf<L>& which) {
  using Number = ScalarOf<L>;
  constexpr std::size_t kSize = sizeof(Kernel<Number>), kStride = kSize / sizeof(Number);
  static_assert(kStride * sizeof(Number) == kSize);
  const IntOf<L> offset = index * IntOf<L>(kStride);
  Kernel<L> result;
  for_each_field(result, *first, [&]<class To, class From>(To& to, const From& from) {
    if constexpr (std::is_same_v<From, bool>) {
      std::uint32_t bits = 0;
      for_each_lane(which, [&](int lane) {
        const auto behind = static_cast<std::size_t>(index[lane]) * kSize;
        bits |= static_cast<std::uint32_t>(*(&from + behind)) << lane;
      });
      to = To::from_bits(bits);
    } else {
      to = L::gather(&from, offset, which);
    }
  });
  return result;
}

}  // namespace alhazen::render
