// render/accel: from boxes to nodes.
#pragma once

#include <vector>

#include "render/accel/tree_node.h"

namespace alhazen::render {

struct NumberedBox {
  TreeBox box;           // finite
  std::uint32_t number;  // of the shape, below 2^31
};

// Node 0 is the root, unless there are no boxes. The same boxes in the same order give the same
// nodes, for any number of threads.
std::vector<TreeNode> build_tree(std::vector<NumberedBox> boxes, int threads);

}  // namespace alhazen::render
