// The nodes themselves: whole, tight, and the same however many threads make them.
#include "render/accel/tree_build.h"

#include <cstring>
#include <gtest/gtest.h>

#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

std::vector<NumberedBox> random_boxes(std::size_t count) {
  Dice dice(91);
  std::vector<NumberedBox> boxes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d at = dice.in_cube(0.9), size = dice.uniform(0, 0.01) * Vec3d{1, 1, 1};
    boxes[i] = {tree_box(at - size, at + size, 1.0), static_cast<std::uint32_t>(i)};
  }
  return boxes;
}

bool is_same(const TreeNode& a, const TreeNode& b) {
  return std::memcmp(&a, &b, sizeof(TreeNode)) == 0;
}

TEST(TreeBuild, SameNodesForAnyNumberOfThreads) {
  const std::vector<NumberedBox> boxes = random_boxes(150000);
  const std::vector<TreeNode> expected = build_tree(boxes, 1);
  for (const int threads : {2, 5}) {
    const std::vector<TreeNode> nodes = build_tree(boxes, threads);
    ASSERT_EQ(nodes.size(), expected.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      ASSERT_TRUE(is_same(nodes[i], expected[i])) << i;
  }
}

// Every shape has one leaf, with its own box; every node but the root one parent, whose box for it
// is the smallest around its children.
TEST(TreeBuild, BoxesAreExactAndNothingIsLost) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, kNodeWidth, kNodeWidth + 1,
                                  std::size_t{100}, std::size_t{3000}, std::size_t{40000}}) {
    const std::vector<NumberedBox> boxes = random_boxes(count);
    const std::vector<TreeNode> nodes = build_tree(boxes, 2);
    std::vector<int> leaves(count), parents(nodes.size());
    for (const TreeNode& node : nodes) {
      for (std::size_t k = 0; k < kNodeWidth; ++k) {
        const auto child_box = [&](const TreeNode& in, std::size_t j) {
          TreeBox box;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            box.bounds[axis] = in.planes[axis][TreeNode::kMin][j];
            box.bounds[axis + 4] = -in.planes[axis][TreeNode::kMax][j];
          }
          return box;
        };
        const TreeBox box = child_box(node, k);
        if (box.min(0) > box.max(0)) continue;  // absent
        TreeBox expected;
        const std::uint32_t index = node.children[k].index();
        if (node.children[k].is_shape()) {
          ++leaves[index];
          expected = boxes[index].box;
        } else {
          ++parents[index];
          for (std::size_t j = 0; j < kNodeWidth; ++j)
            expected.add(child_box(nodes[index], j));
        }
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_EQ(box.min(axis), expected.min(axis));
          ASSERT_EQ(box.max(axis), expected.max(axis));
        }
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(leaves[i], 1) << i << " of " << count;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      ASSERT_EQ(parents[i], i == 0 ? 0 : 1) << i << " of " << count;
  }
}

TEST(TreeBuild, BoxesAreRoundedOutward) {
  Dice dice(92);
  for (int i = 0; i < 10000; ++i) {
    const double scale = std::ldexp(1.0, dice.below(600) - 300);
    const Vec3d a = scale * dice.in_cube(1), b = scale * dice.in_cube(1);
    Vec3d min, max;
    for (int axis = 0; axis < 3; ++axis) {
      min[axis] = std::min(a[axis], b[axis]);
      max[axis] = std::max(a[axis], b[axis]);
    }
    const double units = units_per_length(scale);
    EXPECT_GE(scale * units, 0.5);
    EXPECT_LT(scale * units, 1);
    const TreeBox box = tree_box(min, max, units);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LT(box.min(axis), units * min[axis]);
      EXPECT_GT(box.max(axis), units * max[axis]);
    }
  }
}

}  // namespace
}  // namespace alhazen::render
