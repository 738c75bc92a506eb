#include "render/accel/tree_build.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace alhazen::render {
namespace {

constexpr int kBins = 16;

// Items [begin, end), after so many splits.
template <class Real>
struct Range {
  std::size_t begin, end;
  int splits;
  TreeBox<Real> box;

  std::size_t size() const { return end - begin; }
};

template <class Real>
Real twice_center(const TreeBox<Real>& box, int axis) {
  return box.min[axis] + box.max[axis];
}

template <class Real>
Real half_area(const TreeBox<Real>& box) {
  const Vec3<Real> size = box.max - box.min;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// The bins of one axis between the first and the last of (twice) the centres.
template <class Real>
struct Binning {
  int axis = 0;
  Real from = 0, extent = 0;

  int bin_of(const NumberedBox<Real>& item) const {
    const Real place = (twice_center(item.box, axis) - from) / extent;
    return std::min(kBins - 1, static_cast<int>(place * Real(kBins)));
  }
};

template <class Real>
class Builder {
 public:
  explicit Builder(std::vector<NumberedBox<Real>> boxes) : items_(std::move(boxes)) {}

  TreeNodes<Real> build() {
    if (items_.empty()) return {};
    struct Task {
      Range<Real> range;
      std::uint32_t node;
    };
    result_.nodes.emplace_back();
    std::vector<Task> tasks{{range_of(0, items_.size(), 0), 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      const Children children = children_of(task.range);
      for (std::size_t k = 0; k < children.count; ++k) {
        const Range<Real>& child = children.range[k];
        const bool is_leaf = child.size() <= kLargestLeaf;
        const std::size_t there = is_leaf ? child.begin : result_.nodes.size();
        if (!is_leaf) {
          tasks.push_back({child, static_cast<std::uint32_t>(there)});
          result_.nodes.emplace_back();
        }
        TreeNode<Real>& node = result_.nodes[task.node];
        node.set_box(k, child.box);
        node.child[k] = static_cast<std::uint32_t>(there);
        node.count[k] = is_leaf ? static_cast<std::uint32_t>(child.size()) : 0;
      }
    }
    result_.leaves.reserve(items_.size());
    for (const NumberedBox<Real>& item : items_)
      result_.leaves.push_back(item.number);
    return std::move(result_);
  }

 private:
  struct Children {
    std::array<Range<Real>, kNodeWidth> range;
    std::size_t count;
  };

  Range<Real> range_of(std::size_t begin, std::size_t end, int splits) const {
    Range<Real> range{begin, end, splits, {}};
    for (std::size_t i = begin; i < end; ++i)
      range.box.add(items_[i].box);
    return range;
  }

  // Splits the child with the largest area until there are four or all are leaves.
  Children children_of(const Range<Real>& whole) {
    Children children{{whole}, 1};
    while (children.count < kNodeWidth) {
      Range<Real>* largest = nullptr;
      for (std::size_t k = 0; k < children.count; ++k) {
        Range<Real>& child = children.range[k];
        if (child.size() <= kLargestLeaf) continue;
        if (largest == nullptr || half_area(child.box) > half_area(largest->box)) largest = &child;
      }
      if (largest == nullptr) break;
      const Range<Real> range = *largest;
      const std::size_t middle = split(range);
      *largest = range_of(range.begin, middle, range.splits + 1);
      children.range[children.count++] = range_of(middle, range.end, range.splits + 1);
    }
    return children;
  }

  // Puts the items of one half before those of the other; where the second half begins.
  std::size_t split(const Range<Real>& range) {
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto end = items_.begin() + static_cast<std::ptrdiff_t>(range.end);
    const std::array<Binning<Real>, 3> axes = binnings(range);
    if (range.splits < kDeepestFreeSplit) {
      if (const auto cut = best_cut(range, axes)) {
        const auto middle = std::partition(begin, end, [&cut](const NumberedBox<Real>& item) {
          return cut->binning.bin_of(item) <= cut->last_bin;
        });
        return static_cast<std::size_t>(middle - items_.begin());
      }
    }
    const auto longest = std::max_element(
        axes.begin(), axes.end(), [](const auto& a, const auto& b) { return a.extent < b.extent; });
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
                     [longest](const NumberedBox<Real>& a, const NumberedBox<Real>& b) {
                       const Real at_a = twice_center(a.box, longest->axis),
                                  at_b = twice_center(b.box, longest->axis);
                       return at_a != at_b ? at_a < at_b : a.number < b.number;
                     });
    return static_cast<std::size_t>(middle - items_.begin());
  }

  std::array<Binning<Real>, 3> binnings(const Range<Real>& range) const {
    TreeBox<Real> centers;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Vec3<Real> center = items_[i].box.min + items_[i].box.max;
      centers.add({center, center});
    }
    std::array<Binning<Real>, 3> axes;
    for (int axis = 0; axis < 3; ++axis) {
      axes[static_cast<std::size_t>(axis)] = {axis, centers.min[axis],
                                              centers.max[axis] - centers.min[axis]};
    }
    return axes;
  }

  struct Cut {
    Binning<Real> binning;
    int last_bin;  // of the first half
    Real cost;     // area times number, summed over the halves
  };

  // Nothing if all centres coincide.
  std::optional<Cut> best_cut(const Range<Real>& range,
                              const std::array<Binning<Real>, 3>& axes) const {
    std::optional<Cut> best;
    for (const Binning<Real>& binning : axes) {
      if (!(binning.extent > Real(0))) continue;
      std::array<TreeBox<Real>, kBins> boxes;
      std::array<std::size_t, kBins> counts{};
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const auto bin = static_cast<std::size_t>(binning.bin_of(items_[i]));
        boxes[bin].add(items_[i].box);
        ++counts[bin];
      }
      // Costs of the second halves from the end, then of the first halves from the start.
      std::array<Real, kBins> after{};
      TreeBox<Real> box;
      std::size_t count = 0;
      for (std::size_t k = kBins - 1; k > 0; --k) {
        box.add(boxes[k]);
        count += counts[k];
        if (count > 0) after[k - 1] = half_area(box) * static_cast<Real>(count);
      }
      box = {};
      count = 0;
      for (std::size_t k = 0; k + 1 < kBins; ++k) {
        box.add(boxes[k]);
        count += counts[k];
        if (count == 0 || count == range.size()) continue;
        const Real cost = half_area(box) * static_cast<Real>(count) + after[k];
        if (!best || cost < best->cost) best = Cut{binning, static_cast<int>(k), cost};
      }
    }
    return best;
  }

  std::vector<NumberedBox<Real>> items_;
  TreeNodes<Real> result_;
};

}  // namespace

template <class Real>
TreeNodes<Real> build_tree(std::vector<NumberedBox<Real>> boxes) {
  return Builder<Real>(std::move(boxes)).build();
}

template TreeNodes<float> build_tree(std::vector<NumberedBox<float>>);
template TreeNodes<double> build_tree(std::vector<NumberedBox<double>>);
#if ALHAZEN_HAS_QUAD
template TreeNodes<Quad> build_tree(std::vector<NumberedBox<Quad>>);
#endif

}  // namespace alhazen::render
