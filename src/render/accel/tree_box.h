// render/accel: boxes in the units of a tree.
//
// A tree counts lengths in a power of two such that none of its own is larger than 1, and in
// single precision whatever the scene is computed in: half the bytes, twice the lanes. What is
// rounded is rounded outward, so a box may be larger than it need be, never smaller.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "core/math/vec.h"

namespace alhazen::render {

// Lengths and directions that the error bounds of the tree speak of: nothing that is made of them
// overflows, and what underflows is too small to count.
template <class Real>
constexpr Real largest_ordinary() {
  if constexpr (std::is_same_v<Real, float>) {
    return 0x1p48f;
  } else {
    return Real(0x1p384);
  }
}
template <class Real>
constexpr bool is_ordinary(Real length) {
  return length >= Real(1) / largest_ordinary<Real>() && length <= largest_ordinary<Real>();
}

inline constexpr float kTreeRoundoff = ScalarTraits<float>::unit_roundoff();
// A length that does not count beside a tree's, and that sets every box apart from numbers too
// small to be told from 0.
inline constexpr float kNothing = kTreeRoundoff * kTreeRoundoff * kTreeRoundoff * kTreeRoundoff;

// The units of a tree in which no coordinate is larger than `size`, which is ordinary.
template <class Real>
inline Real units_per_length(Real size) {
  return static_cast<Real>(std::ldexp(1.0, -1 - std::ilogb(static_cast<double>(size))));
}

// Two boxes are joined by one minimum.
struct TreeBox {
  std::array<float, 8> bounds;  // min x, y, z, 0, -max x, -max y, -max z, 0

  TreeBox() { bounds.fill(infinity<float>()); }  // the empty box
  float min(int axis) const { return bounds[static_cast<std::size_t>(axis)]; }
  float max(int axis) const { return -bounds[static_cast<std::size_t>(axis) + 4]; }
  void add(const TreeBox& other) {
    for (std::size_t i = 0; i < bounds.size(); ++i)
      bounds[i] = smaller(bounds[i], other.bounds[i]);
  }
};

// Half of the surface's area.
inline float half_area(const TreeBox& box) {
  const float x = box.max(0) - box.min(0), y = box.max(1) - box.min(1), z = box.max(2) - box.min(2);
  return x * y + y * z + z * x;
}

// The box from min to max, both finite, moved outward by what tree_ray.h wants to have spare.
template <class Real>
inline TreeBox tree_box(Vec3<Real> min, Vec3<Real> max, Real units) {
  const auto outward = [units](Real bound) {
    const float nearest = static_cast<float>(units * bound);
    return nearest - (32 * kTreeRoundoff * absolute(nearest) + kNothing);
  };
  TreeBox box;
  box.bounds = {outward(min.x),  outward(min.y),  outward(min.z),  0,
                outward(-max.x), outward(-max.y), outward(-max.z), 0};
  return box;
}

}  // namespace alhazen::render
