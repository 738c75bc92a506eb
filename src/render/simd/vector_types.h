// render/simd: the compiler's vectors: +, -, *, /, comparisons and bits are its operators.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

namespace alhazen::render {

template <class T, int W>
struct VectorOf {
  typedef T Type __attribute__((vector_size(sizeof(T) * W)));
};
template <class T, int W>
using Vector = typename VectorOf<T, W>::Type;

// The whole number as wide as a T, and lanes of it: what a comparison of lanes of T gives.
template <class T>
using WordOf = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

template <class T, int W>
using Words = Vector<WordOf<T>, W>;

template <class T, int W>
inline Vector<T, W> broadcast_vector(T x) {
  return [x]<int... I>(std::integer_sequence<int, I...>) {
    return Vector<T, W>{((void)I, x)...};
  }
  (std::make_integer_sequence<int, W>{});
}
template <class T, int W>
inline Vector<T, W> iota_vector() {
  return []<int... I>(std::integer_sequence<int, I...>) {
    return Vector<T, W>{static_cast<T>(I)...};
  }
  (std::make_integer_sequence<int, W>{});
}

// `N` lanes of v from `first` on.
template <class T, int W, int N, int first>
inline Vector<T, N> part_of_vector(Vector<T, W> v) {
  return [v]<int... I>(std::integer_sequence<int, I...>)->Vector<T, N> {
    return __builtin_shufflevector(v, v, (first + I)...);
  }
  (std::make_integer_sequence<int, N>{});
}
template <class T, int W>
inline Vector<T, 2 * W> joined_vectors(Vector<T, W> low, Vector<T, W> high) {
  return [=]<int... I>(std::integer_sequence<int, I...>)->Vector<T, 2 * W> {
    return __builtin_shufflevector(low, high, I...);
  }
  (std::make_integer_sequence<int, 2 * W>{});
}

// The same bits as another type of vector.
template <class To, class From>
inline To vector_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  __builtin_memcpy(&to, &from, sizeof(to));
  return to;
}

}  // namespace alhazen::render
