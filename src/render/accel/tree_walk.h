// render/accel: one ray through the nodes of a tree, from near to far.
#pragma once

#include <span>

#include "render/accel/tree_ray.h"

namespace alhazen::render {

// Calls consider(shape) for every shape below `root` whose box the ray meets before `to`, until it
// returns false; whether it never did. `to` is read anew after each shape.
template <class Real, class Consider>
inline bool walk(std::span<const TreeNode> nodes, TreeChild root, const TreeRay& ray,
                 const TreeClock<Real>& clock, const Real& to, const Consider& consider) {
  struct Waiting {
    float near;
    TreeChild child;
  };
  // Each node on the way down leaves at most all of its children but one.
  std::array<Waiting, (kNodeWidth - 1) * kDeepestSplit + kNodeWidth> stack;
  stack[0] = {0, root};
  std::size_t waiting = 1;
  float end = clock.until(to);
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.near > end) continue;
    if (next.child.is_shape()) {
      if (!consider(next.child.index())) return false;
      end = clock.until(to);
      continue;
    }
    const TreeNode& node = nodes[next.child.index()];
    const TreeRay::Met met = ray.meet(node, end);
    std::array<float, kNodeWidth> near;
    met.near.store(near.data());
    const std::size_t bottom = waiting;
    for_each_lane(met.mask, [&](int lane) {
      // The nearest on top.
      const auto k = static_cast<std::size_t>(lane);
      std::size_t place = waiting++;
      for (; place > bottom && stack[place - 1].near < near[k]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {near[k], node.children[k]};
    });
  }
  return true;
}

}  // namespace alhazen::render
