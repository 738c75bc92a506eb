// render/accel: from boxes to nodes.
#pragma once

#include "render/accel/tree_node.h"

namespace alhazen::render {

template <class Real>
struct NumberedBox {
  TreeBox<Real> box;  // finite
  std::uint32_t number;
};

// The same boxes in the same order give the same nodes.
template <class Real>
TreeNodes<Real> build_tree(std::vector<NumberedBox<Real>> boxes);

}  // namespace alhazen::render
