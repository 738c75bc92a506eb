// render/accel: the nodes of a tree of shapes.
#pragma once

#include <array>
#include <cstdint>

#include "render/accel/tree_box.h"
#include "render/simd/wide.h"

namespace alhazen::render {

// As many boxes as a register has floats, but at least eight.
inline constexpr std::size_t kNodeWidth = std::max(8, kWideWidth<float>);
// Below this many splits the halves are equal in number, so that a tree of 2^31 shapes is no deeper
// than kDeepestSplit.
inline constexpr int kDeepestFreeSplit = 40;
inline constexpr int kDeepestSplit = kDeepestFreeSplit + 31;

// A node, or one shape: a kernel costs more than a box (docs/acceleration.md).
class TreeChild {
 public:
  static TreeChild node(std::size_t index) { return TreeChild(static_cast<std::uint32_t>(index)); }
  static TreeChild shape(std::uint32_t id) { return TreeChild(kShape | id); }
  TreeChild() = default;

  bool is_shape() const { return (word_ & kShape) != 0; }
  std::uint32_t index() const { return word_ & ~kShape; }

 private:
  static constexpr std::uint32_t kShape = 0x80000000;
  explicit TreeChild(std::uint32_t word) : word_(word) {}

  std::uint32_t word_;  // stacks of children are not to be filled with anything first
};

// The boxes of up to kNodeWidth children, side by side for lanes. An absent child has the empty
// box, min = +infinity and max = -infinity, which no ray meets.
struct TreeNode {
  enum : std::size_t { kMin, kMax };

  std::array<std::array<std::array<float, kNodeWidth>, 2>, 3> planes;  // [axis][kMin, kMax][child]
  std::array<TreeChild, kNodeWidth> children{};

  TreeNode() {
    for (std::size_t k = 0; k < kNodeWidth; ++k)
      set_box(k, TreeBox());
  }
  void set_box(std::size_t k, const TreeBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      auto& there = planes[static_cast<std::size_t>(axis)];
      there[kMin][k] = box.min(axis);
      there[kMax][k] = box.max(axis);
    }
  }
};

}  // namespace alhazen::render
