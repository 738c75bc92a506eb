#include "render/accel/bounds_tree.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "render/accel/tree_build.h"

namespace alhazen::render {
namespace {

// An item whose reach is more roundings than this (a cone, a map that nearly is singular) is kept
// from making every other box larger: its own is grown for all rays that start within the tree's
// radius. A choice of cost alone: either way the boxes hold every hit.
constexpr int kCommonRoundings = 4096;
constexpr std::size_t kItemsAtOnce = 4096;  // whose bounds one thread computes

template <class Real>
constexpr Real kCommonReach = Real(kCommonRoundings) * ScalarTraits<Real>::unit_roundoff();

template <class Real>
Real size_of(const ShapeBounds<Real>& bounds) {
  return larger(largest_coordinate(bounds.min), largest_coordinate(bounds.max));
}

// Nothing where they serve for no box.
template <class Real>
std::optional<ShapeBounds<Real>> useful(std::optional<ShapeBounds<Real>> bounds) {
  if (bounds && is_finite(bounds->min) && is_finite(bounds->max) && bounds->reach < Real(1) &&
      is_ordinary(size_of(*bounds))) {
    return bounds;
  }
  return std::nullopt;
}

// What has to be known of all items before the first box.
template <class Real>
struct Survey {
  Real start_radius = 0;
  Real near_reach = Real(8) * ScalarTraits<Real>::unit_roundoff(), far_reach = 0;
  std::vector<std::uint32_t> outside;
  std::size_t inside = 0;
  Vec3<Real> min{infinity<Real>(), infinity<Real>(), infinity<Real>()}, max = -min;

  void add(std::uint32_t item, const std::optional<ShapeBounds<Real>>& bounds) {
    if (!bounds) {
      outside.push_back(item);
      return;
    }
    ++inside;
    start_radius = larger(start_radius, size_of(*bounds));
    far_reach = larger(far_reach, bounds->reach);
    widen(bounds->min, bounds->max);
    if (bounds->reach <= kCommonReach<Real>) near_reach = larger(near_reach, bounds->reach);
  }
  void add(const Survey& other) {
    start_radius = larger(start_radius, other.start_radius);
    near_reach = larger(near_reach, other.near_reach);
    far_reach = larger(far_reach, other.far_reach);
    outside.insert(outside.end(), other.outside.begin(), other.outside.end());
    inside += other.inside;
    widen(other.min, other.max);
  }
  void widen(Vec3<Real> low, Vec3<Real> high) {
    for (int i = 0; i < 3; ++i) {
      min[i] = smaller(min[i], low[i]);
      max[i] = larger(max[i], high[i]);
    }
  }
};

// Calls work(k, first, last) for each run of items [first, last), the k-th.
template <class Work>
void for_runs(int threads, std::uint32_t items, const Work& work) {
  const std::size_t runs = (items + kItemsAtOnce - 1) / kItemsAtOnce;
  in_parallel(threads, runs, [&](std::size_t k) {
    const std::size_t first = k * kItemsAtOnce;
    work(k, static_cast<std::uint32_t>(first),
         static_cast<std::uint32_t>(std::min<std::size_t>(first + kItemsAtOnce, items)));
  });
}

}  // namespace

template <class Real>
BoundsTree<Real>::BoundsTree(std::uint32_t items, const BoundsOf& bounds_of,
                             const std::function<bool(std::uint32_t)>& belongs, int threads) {
  std::vector<Survey<Real>> surveys(items / kItemsAtOnce + 1);
  for_runs(threads, items, [&](std::size_t k, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t item = first; item < last; ++item)
      if (belongs(item)) surveys[k].add(item, useful(bounds_of(item)));
  });
  Survey<Real> all;
  std::vector<std::size_t> inside_before;
  for (const Survey<Real>& survey : surveys) {
    inside_before.push_back(all.inside);
    all.add(survey);
  }
  outside_ = std::move(all.outside);
  if (all.inside == 0) return;
  if (outside_.empty()) bounds_ = {all.min, all.max, all.far_reach};
  // A grown box may be twice as far away.
  frame_ = {all.start_radius,
            all.near_reach,
            all.far_reach,
            units_per_length(Real(2) * all.start_radius),
            {},
            {}};
  std::vector<NumberedBox> boxes(all.inside);
  for_runs(threads, items, [&](std::size_t k, std::uint32_t first, std::uint32_t last) {
    std::size_t place = inside_before[k];
    for (std::uint32_t item = first; item < last; ++item) {
      if (!belongs(item)) continue;
      const auto bounds = useful(bounds_of(item));
      if (!bounds) continue;
      const Real by =
          bounds->reach <= kCommonReach<Real> ? Real(0) : bounds->reach * frame_.start_radius;
      const Vec3<Real> margin{by, by, by};
      boxes[place++] = {tree_box(bounds->min - margin, bounds->max + margin, frame_.units), item};
    }
  });
  if (boxes.size() == 1) {  // its kernel alone costs less
    outside_.insert(std::lower_bound(outside_.begin(), outside_.end(), boxes[0].number),
                    boxes[0].number);
    return;
  }
  TreeBox around;
  for (const NumberedBox& box : boxes)
    around.add(box.box);
  for (int axis = 0; axis < 3; ++axis) {
    frame_.min[axis] = static_cast<Real>(around.min(axis)) / frame_.units;
    frame_.max[axis] = static_cast<Real>(around.max(axis)) / frame_.units;
  }
  nodes_ = build_tree(std::move(boxes), threads);
}

template <class Real>
std::size_t BoundsTree<Real>::bytes() const {
  return nodes_.size() * sizeof(TreeNode) + outside_.size() * sizeof(std::uint32_t);
}

template class BoundsTree<float>;
template class BoundsTree<double>;
#if ALHAZEN_HAS_QUAD
template class BoundsTree<Quad>;
#endif

}  // namespace alhazen::render
