#include "render/accel/tree_build.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "render/accel/tree_split.h"

namespace alhazen::render {
namespace {

// Subtrees of no more shapes than this are built by one thread each. What is larger is split level
// by level, the nodes of a level at once. The tree does not depend on it.
constexpr std::size_t kLargestJob = 1 << 14;

struct Children {
  std::array<TreeRange, kNodeWidth> range;
  std::size_t count;
};

// Puts the shapes of child `k` in its place, and behind the others.
void take_in(std::span<const NumberedBox> items, std::size_t k, Children& children) {
  const TreeRange range = children.range[k];
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const std::size_t place = i == range.begin ? k : children.count++;
    children.range[place] = range_of(items, i, i + 1);
  }
}

// Splits the child with the largest area until the node is full or all fit into one node each.
// Where there is room, the smallest of them needs no node.
Children children_of(std::span<NumberedBox> items, const TreeRange& whole) {
  Children children{{whole}, 1};
  while (children.count < kNodeWidth) {
    TreeRange* largest = nullptr;
    for (std::size_t k = 0; k < children.count; ++k) {
      TreeRange& child = children.range[k];
      if (child.size() <= kNodeWidth) continue;
      if (largest == nullptr || half_area(child.box) > half_area(largest->box)) largest = &child;
    }
    if (largest == nullptr) break;
    const auto halves = split(items, *largest);
    *largest = halves[0];
    children.range[children.count++] = halves[1];
  }
  for (;;) {
    std::size_t smallest = children.count;
    for (std::size_t k = 0; k < children.count; ++k) {
      const std::size_t size = children.range[k].size();
      if (size < 2) continue;
      if (smallest == children.count || size < children.range[smallest].size()) smallest = k;
    }
    if (smallest == children.count ||
        children.count + children.range[smallest].size() - 1 > kNodeWidth) {
      return children;
    }
    take_in(items, smallest, children);
  }
}

// A range that node `parent` has as a child and that has no node yet.
struct Pending {
  TreeRange range;
  std::size_t parent, place;
};

// Appends the node of the children; what of them is no single shape is given to `later`.
template <class Later>
void add_node(std::span<const NumberedBox> items, const Children& children,
              std::vector<TreeNode>& nodes, const Later& later) {
  const std::size_t index = nodes.size();
  nodes.emplace_back();
  for (std::size_t k = 0; k < children.count; ++k) {
    const TreeRange& range = children.range[k];
    nodes[index].set_box(k, range.box);
    if (range.size() == 1) {
      nodes[index].children[k] = TreeChild::shape(items[range.begin].number);
    } else {
      later(Pending{range, index, k});
    }
  }
}

std::vector<TreeNode> build_subtree(std::span<NumberedBox> items, const TreeRange& whole) {
  std::vector<TreeNode> nodes;
  std::vector<Pending> stack;
  const auto push = [&stack](const Pending& pending) { stack.push_back(pending); };
  add_node(items, children_of(items, whole), nodes, push);
  while (!stack.empty()) {
    const Pending next = stack.back();
    stack.pop_back();
    nodes[next.parent].children[next.place] = TreeChild::node(nodes.size());
    add_node(items, children_of(items, next.range), nodes, push);
  }
  return nodes;
}

// Appends the nodes of a subtree, which number themselves from 0; where its root stands now.
std::size_t append(const std::vector<TreeNode>& subtree, std::vector<TreeNode>& nodes) {
  const std::size_t first = nodes.size();
  for (TreeNode node : subtree) {
    for (TreeChild& child : node.children) {
      if (!child.is_shape()) child = TreeChild::node(first + child.index());
    }
    nodes.push_back(node);
  }
  return first;
}

// The nodes above the jobs; the jobs, in an order that depends on the boxes alone.
std::vector<Pending> build_top(std::span<NumberedBox> items, const TreeRange& whole, int threads,
                               std::vector<TreeNode>& nodes) {
  std::vector<Pending> jobs, level{{whole, 0, 0}};
  while (!level.empty()) {
    std::vector<Children> children(level.size());
    in_parallel(threads, level.size(),
                [&](std::size_t i) { children[i] = children_of(items, level[i].range); });
    std::vector<Pending> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (!nodes.empty())
        nodes[level[i].parent].children[level[i].place] = TreeChild::node(nodes.size());
      add_node(items, children[i], nodes, [&](const Pending& pending) {
        (pending.range.size() > kLargestJob ? next : jobs).push_back(pending);
      });
    }
    level = std::move(next);
  }
  return jobs;
}

}  // namespace

std::vector<TreeNode> build_tree(std::vector<NumberedBox> boxes, int threads) {
  if (boxes.empty()) return {};
  const TreeRange whole = range_of(boxes, 0, boxes.size());
  if (whole.size() <= kLargestJob) return build_subtree(boxes, whole);
  std::vector<TreeNode> nodes;
  const std::vector<Pending> jobs = build_top(boxes, whole, threads, nodes);
  std::vector<std::vector<TreeNode>> subtrees(jobs.size());
  in_parallel(threads, jobs.size(),
              [&](std::size_t i) { subtrees[i] = build_subtree(boxes, jobs[i].range); });
  boxes = std::vector<NumberedBox>();  // `= {}` would keep the memory
  std::size_t count = nodes.size();
  for (const auto& subtree : subtrees)
    count += subtree.size();
  nodes.reserve(count);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const std::size_t root = append(subtrees[i], nodes);
    nodes[jobs[i].parent].children[jobs[i].place] = TreeChild::node(root);
    subtrees[i] = std::vector<TreeNode>();
  }
  return nodes;
}

}  // namespace alhazen::render
