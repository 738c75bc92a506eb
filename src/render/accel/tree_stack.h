// render/accel: what a single ray has still to look at of a tree.
#pragma once

#include <array>
#include <utility>

#include "render/accel/tree_ray.h"

namespace alhazen::render {

// The nearest on top. A ray meets one or two children of most nodes: the nearest is handed out at
// once, and nothing is put by only to be taken again.
class TreeStack {
 public:
  // Puts by all children that the ray meets but the nearest, and returns that. There is one.
  TreeChild put_by(const TreeNode& node, const TreeRay::Met& met) {
    std::array<float, kNodeWidth> near;
    met.near.store(near.data());
    std::uint32_t left = met.mask.bits();
    const auto next = [&] {
      const auto k = static_cast<std::size_t>(__builtin_ctz(left));
      left &= left - 1;
      return Waiting{near[k], node.children[k]};
    };
    Waiting nearest = next();
    const std::size_t bottom = waiting_;
    while (left != 0) {
      Waiting other = next();
      if (other.near < nearest.near) std::swap(other, nearest);
      std::size_t place = waiting_++;
      for (; place > bottom && stack_[place - 1].near < other.near; --place)
        stack_[place] = stack_[place - 1];
      stack_[place] = other;
    }
    return nearest.child;
  }
  // The next that the ray meets no later than at `end`; false if none is left.
  bool take(float end, TreeChild& child) {
    while (waiting_ > 0) {
      const Waiting next = stack_[--waiting_];
      if (next.near > end) continue;
      child = next.child;
      return true;
    }
    return false;
  }

 private:
  struct Waiting {
    float near;
    TreeChild child;
  };

  // Each node on the way down leaves at most all of its children but one.
  std::array<Waiting, (kNodeWidth - 1) * kDeepestSplit + kNodeWidth> stack_;
  std::size_t waiting_ = 0;
};

}  // namespace alhazen::render
