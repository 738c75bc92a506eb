// tests: a kernel on lanes gives the bits that it gives for each of the numbers alone.
#pragma once

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/math/random.h"
#include "core/math/vec.h"
#include "render/simd/elementary.h"
#include "render/simd/records.h"

namespace alhazen::render {

// A number in [0, 1) with 32 bits: the j-th of trial i.
inline double drawn(int i, int j) {
  return static_cast<double>(static_cast<std::uint32_t>(mix_64(mix_64(91, i), j))) * 0x1p-32;
}
// One of the list, or, three times out of four, a number between its first and its last.
inline double drawn_from(const std::vector<double>& edges, int i, int j) {
  const auto pick =
      static_cast<std::size_t>(4 * static_cast<double>(edges.size()) * drawn(i, j + 1000));
  if (pick < edges.size()) return edges[pick];
  return edges.front() + (edges.back() - edges.front()) * drawn(i, j);
}

// What kernels return is looked at number by number.
template <class Real>
using Numbers = std::vector<Real>;
template <class Real>
void put(Numbers<Real>& to, Real x) {
  to.push_back(x);
}
template <class Real>
void put(Numbers<Real>& to, Vec3<Real> v) {
  to.insert(to.end(), {v.x, v.y, v.z});
}
template <class Real>
void put(Numbers<Real>& to, Rgb<Real> c) {
  to.insert(to.end(), {c.r, c.g, c.b});
}
template <class Real>
void put_mask(Numbers<Real>& to, MaskOf<Real> mask) {
  to.push_back(select(mask, Real(1), Real(0)));
}

template <class T>
bool same_bits(T a, T b) {
  const bool nan_a = is_nan(a), nan_b = is_nan(b);
  if (nan_a || nan_b) return nan_a && nan_b;
  return a == b && ScalarTraits<T>::sign_bit(a) == ScalarTraits<T>::sign_bit(b);
}

// `argument(i, j)` is the j-th argument of the i-th trial; the kernel takes an array of them and
// appends its results.
template <class L, std::size_t count, class Argument, class Kernel>
void expect_lanes_agree(int trials, const Argument& argument, const Kernel& kernel) {
  using T = ScalarOf<L>;
  for (int first = 0; first < trials; first += L::kWidth) {
    std::array<L, count> together;
    std::array<std::array<T, count>, L::kWidth> alone;
    for (int lane = 0; lane < L::kWidth; ++lane) {
      for (std::size_t j = 0; j < count; ++j) {
        alone[lane][j] = static_cast<T>(argument(first + lane, static_cast<int>(j)));
        together[j].set(lane, alone[lane][j]);
      }
    }
    Numbers<L> all;
    kernel(all, together);
    for (int lane = 0; lane < L::kWidth; ++lane) {
      Numbers<T> one;
      kernel(one, alone[lane]);
      ASSERT_EQ(one.size(), all.size());
      for (std::size_t k = 0; k < one.size(); ++k) {
        ASSERT_TRUE(same_bits(one[k], all[k][lane]))
            << "trial " << first + lane << ", result " << k << ": " << static_cast<double>(one[k])
            << " alone, " << static_cast<double>(all[k][lane]) << " in lanes";
      }
    }
  }
}

// The same for lanes of each kind of number.
template <std::size_t count, class Argument, class Kernel>
void expect_all_lanes_agree(const Argument& argument, const Kernel& kernel, int trials = 4000) {
  expect_lanes_agree<Lanes<double, 4>, count>(trials, argument, kernel);
  expect_lanes_agree<Lanes<float, 8>, count>(trials, argument, kernel);
#if ALHAZEN_HAS_QUAD
  expect_lanes_agree<Lanes<Quad, 1>, count>(trials / 16, argument, kernel);
#endif
}

}  // namespace alhazen::render
