// render/accel: the nodes of a tree of shapes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/math/vec.h"

namespace alhazen::render {

inline constexpr int kNodeWidth = 4;
// A leaf holds no more shapes than this: a kernel costs more than a box (docs/acceleration.md).
inline constexpr int kLargestLeaf = 1;
// Below this many splits the halves are equal in number, so that a tree of 2^32 shapes is no deeper
// than kDeepestSplit.
inline constexpr int kDeepestFreeSplit = 40;
inline constexpr int kDeepestSplit = kDeepestFreeSplit + 32;

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

template <class Real>
struct TreeBox {
  Vec3<Real> min{infinity<Real>(), infinity<Real>(), infinity<Real>()};
  Vec3<Real> max = -min;

  void add(const TreeBox& other) {
    for (int i = 0; i < 3; ++i) {
      min[i] = smaller(min[i], other.min[i]);
      max[i] = larger(max[i], other.max[i]);
    }
  }
};

// The boxes of up to four children, side by side for lanes. An absent child has an empty box, min =
// +infinity and max = -infinity, which no ray meets.
template <class Real>
struct TreeNode {
  enum : std::size_t { kMin, kMax };
  using Lanes = std::array<Real, kNodeWidth>;

  std::array<std::array<Lanes, 2>, 3> planes;     // [axis][kMin or kMax][child]
  std::array<std::uint32_t, kNodeWidth> child{};  // a node, or the first shape of a leaf
  std::array<std::uint32_t, kNodeWidth> count{};  // of the shapes of a leaf; 0: a node

  TreeNode() {
    for (std::size_t k = 0; k < kNodeWidth; ++k)
      set_box(k, TreeBox<Real>());
  }
  void set_box(std::size_t k, const TreeBox<Real>& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      planes[axis][kMin][k] = box.min[static_cast<int>(axis)];
      planes[axis][kMax][k] = box.max[static_cast<int>(axis)];
    }
  }
};

// Node 0 is the root, unless there are no nodes. Leaves are ranges of `leaves`, which holds what
// the boxes were numbered with.
template <class Real>
struct TreeNodes {
  std::vector<TreeNode<Real>> nodes;
  std::vector<std::uint32_t> leaves;
};

}  // namespace alhazen::render
