// render/accel: one ray through the nodes of a tree, from near to far.
#pragma once

#include <span>

#include "render/accel/tree_stack.h"

namespace alhazen::render {

// Calls consider(shape) for every shape below `root` whose box the ray meets before `to`, until it
// returns false; whether it never did. `to` is read anew after each shape.
template <class Real, class Consider>
inline bool walk(std::span<const TreeNode> nodes, TreeChild root, const TreeRay& ray,
                 const TreeClock<Real>& clock, const Real& to, const Consider& consider) {
  TreeStack stack;
  float end = clock.until(to);
  for (TreeChild child = root;;) {
    if (child.is_shape()) {
      if (!consider(child.index())) return false;
      end = clock.until(to);
    } else {
      const TreeNode& node = nodes[child.index()];
      const TreeRay::Met met = ray.meet(node, end);
      if (any(met.mask)) {
        child = stack.put_by(node, met);
        continue;
      }
    }
    if (!stack.take(end, child)) return true;
  }
}

}  // namespace alhazen::render
