#include "render/accel/tree_split.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace alhazen::render {
namespace {

constexpr std::size_t kBins = 16;
using Row = std::array<float, 4>;  // x, y, z and nothing

Row twice_center(const TreeBox& box) {
  Row result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = box.bounds[i] - box.bounds[i + 4];
  return result;
}

// Equal parts of each axis between the first and the last of the centres.
class Bins {
 public:
  explicit Bins(const TreeBox& centers) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float extent = -centers.bounds[axis + 4] - centers.bounds[axis];
      from_[axis] = centers.bounds[axis];
      // What does not extend has one bin.
      per_length_[axis] = extent > kNothing ? static_cast<float>(kBins) / extent : 0;
    }
  }
  bool has_several(std::size_t axis) const { return per_length_[axis] > 0; }

  // Per axis.
  std::array<int, 4> of(const TreeBox& box) const {
    const Row center = twice_center(box);
    std::array<int, 4> result;
    for (std::size_t i = 0; i < 4; ++i) {
      const int bin = static_cast<int>((center[i] - from_[i]) * per_length_[i]);
      result[i] = std::min(bin, static_cast<int>(kBins) - 1);
    }
    return result;
  }

 private:
  Row from_{}, per_length_{};
};

struct Cut {
  std::size_t axis;
  int last_bin;  // of the first half
  float cost;    // area times number, summed over the halves
};

struct BinContents {
  std::array<TreeBox, kBins> boxes;
  std::array<std::uint32_t, kBins> counts{};
};

void choose_cut(const BinContents& bins, std::size_t axis, std::size_t size,
                std::optional<Cut>& best) {
  // Costs of the second halves from the end, then of the first halves from the start.
  std::array<float, kBins> after{};
  TreeBox box;
  std::size_t count = 0;
  float cost = 0;
  for (std::size_t k = kBins - 1; k > 0; --k) {
    if (bins.counts[k] > 0) {
      box.add(bins.boxes[k]);
      count += bins.counts[k];
      cost = half_area(box) * static_cast<float>(count);
    }
    after[k - 1] = cost;
  }
  box = {};
  count = 0;
  for (std::size_t k = 0; k + 1 < kBins; ++k) {
    if (bins.counts[k] == 0) continue;  // a cut that was there before
    box.add(bins.boxes[k]);
    count += bins.counts[k];
    if (count == size) break;
    cost = half_area(box) * static_cast<float>(count) + after[k];
    if (!best || cost < best->cost) best = Cut{axis, static_cast<int>(k), cost};
  }
}

// Nothing if all centres coincide.
std::optional<Cut> best_cut(std::span<const NumberedBox> items, const Bins& bins) {
  std::array<BinContents, 3> contents;
  for (const NumberedBox& item : items) {
    const auto bin = bins.of(item.box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto there = static_cast<std::size_t>(bin[axis]);
      contents[axis].boxes[there].add(item.box);
      ++contents[axis].counts[there];
    }
  }
  std::optional<Cut> best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (bins.has_several(axis)) choose_cut(contents[axis], axis, items.size(), best);
  }
  return best;
}

// The two halves that `is_first` tells apart, put one after the other.
template <class IsFirst>
std::array<TreeRange, 2> partition(std::span<NumberedBox> items, const TreeRange& range,
                                   const IsFirst& is_first) {
  TreeRange first, second;
  first.splits = second.splits = range.splits + 1;
  first.begin = range.begin;
  second.end = range.end;
  std::size_t low = range.begin, high = range.end;
  while (low < high) {
    if (is_first(items[low])) {
      first.add(items[low++].box);
    } else {
      second.add(items[low].box);
      std::swap(items[low], items[--high]);
    }
  }
  first.end = second.begin = low;
  return {first, second};
}

// Equal numbers, along the axis on which the centres extend farthest.
std::array<TreeRange, 2> split_in_the_middle(std::span<NumberedBox> items, const TreeRange& range) {
  const auto extent = [&range](int axis) {
    return range.centers.max(axis) - range.centers.min(axis);
  };
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (extent(axis) > extent(longest)) longest = axis;
  }
  const auto axis = static_cast<std::size_t>(longest);
  const std::size_t middle = range.begin + range.size() / 2;
  const auto at = [&items](std::size_t i) {
    return items.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::nth_element(at(range.begin), at(middle), at(range.end),
                   [axis](const NumberedBox& a, const NumberedBox& b) {
                     const float at_a = twice_center(a.box)[axis], at_b = twice_center(b.box)[axis];
                     return at_a != at_b ? at_a < at_b : a.number < b.number;
                   });
  std::array<TreeRange, 2> halves{range_of(items, range.begin, middle),
                                  range_of(items, middle, range.end)};
  halves[0].splits = halves[1].splits = range.splits + 1;
  return halves;
}

}  // namespace

void TreeRange::add(const TreeBox& item) {
  box.add(item);
  const Row center = twice_center(item);
  for (std::size_t i = 0; i < 4; ++i) {
    centers.bounds[i] = smaller(centers.bounds[i], center[i]);
    centers.bounds[i + 4] = smaller(centers.bounds[i + 4], -center[i]);
  }
}

TreeRange range_of(std::span<const NumberedBox> items, std::size_t begin, std::size_t end) {
  TreeRange range;
  range.begin = begin;
  range.end = end;
  for (const NumberedBox& item : items.subspan(begin, end - begin))
    range.add(item.box);
  return range;
}

std::array<TreeRange, 2> split(std::span<NumberedBox> items, const TreeRange& range) {
  if (range.splits < kDeepestFreeSplit) {
    const Bins bins(range.centers);
    if (const auto cut = best_cut(items.subspan(range.begin, range.size()), bins)) {
      return partition(items, range, [&](const NumberedBox& item) {
        return bins.of(item.box)[cut->axis] <= cut->last_bin;
      });
    }
  }
  return split_in_the_middle(items, range);
}

}  // namespace alhazen::render
