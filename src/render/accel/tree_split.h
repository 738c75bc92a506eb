// render/accel: how boxes are parted: the binned surface area heuristic (I. Wald, "On fast
// construction of SAH-based bounding volume hierarchies", 2007).
#pragma once

#include <array>
#include <span>

#include "render/accel/tree_build.h"

namespace alhazen::render {

// The items [begin, end), after so many splits, with the box around them and the box around (twice)
// the centres of their boxes.
struct TreeRange {
  std::size_t begin = 0, end = 0;
  int splits = 0;
  TreeBox box, centers;

  std::size_t size() const { return end - begin; }
  void add(const TreeBox& item);
};

// Of items [begin, end).
TreeRange range_of(std::span<const NumberedBox> items, std::size_t begin, std::size_t end);

// Puts the items of one half before those of the other. The range has two items at least, and so
// has none of the halves none.
std::array<TreeRange, 2> split(std::span<NumberedBox> items, const TreeRange& range);

}  // namespace alhazen::render
