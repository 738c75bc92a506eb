// render/accel: from boxes to nodes.
#pragma once

#include "render/accel/tree_node.h"

namespace alhazen::render {

// All coordinates finite. The same boxes give the same nodes.
template <class Real>
TreeNodes<Real> build_tree(const std::vector<TreeBox<Real>>& boxes);

}  // namespace alhazen::render
