// render/accel: a tree of boxes over numbered items, shapes or instances: a bounding volume
// hierarchy. It says which items a ray may meet, and leaves none out that it does meet
// (docs/acceleration.md).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "render/accel/tree_approach.h"
#include "render/accel/tree_walk.h"

namespace alhazen::render {

template <class Real>
class BoundsTree {
 public:
  // Of an item; nothing where it has none. Threads call it side by side.
  using BoundsOf = std::function<std::optional<ShapeBounds<Real>>(std::uint32_t item)>;

  // Of the items for which `belongs` is true. The same tree for any number of threads.
  BoundsTree(std::uint32_t items, const BoundsOf& bounds_of,
             const std::function<bool(std::uint32_t item)>& belongs, int threads);

  // Items that every ray is tested against, and what is met by way of the others.
  std::span<const std::uint32_t> outside() const { return outside_; }
  std::span<const TreeNode> nodes() const { return nodes_; }
  const TreeFrame<Real>& frame() const { return frame_; }
  // Calls visit(item) for each of the others, until it returns false; whether it never did.
  template <class Visit>
  bool for_each_inside(const Visit& visit) const {
    for (const TreeNode& node : nodes_) {
      for (const TreeChild child : node.children) {
        if (child.is_shape() && !visit(child.index())) return false;
      }
    }
    return true;
  }
  // Of all items; nothing if one of them has none, or there is none.
  const std::optional<ShapeBounds<Real>>& bounds() const { return bounds_; }
  // Of the tree alone, without the items.
  std::size_t bytes() const;

  // Calls consider(item) for every item that the ray may meet with from <= t <= to, and for others,
  // until it returns false; whether it never did. `to` is read anew each time.
  template <class Consider>
  bool visit(const Ray<Real>& ray, Real from, const Real& to, const Consider& consider) const;

 private:
  std::vector<TreeNode> nodes_;
  std::vector<std::uint32_t> outside_;  // what has no useful bounds, as a plane
  TreeFrame<Real> frame_;
  std::optional<ShapeBounds<Real>> bounds_;
};

template <class Real>
template <class Consider>
inline bool BoundsTree<Real>::visit(const Ray<Real>& ray, Real from, const Real& to,
                                    const Consider& consider) const {
  for (const std::uint32_t item : outside_) {
    if (!consider(item)) return false;
  }
  if (nodes_.empty()) return true;
  const Approach<Real> way = approach(frame_, ray, from, to);
  if (way.lost && !for_each_inside(consider)) return false;
  return !way.enters ||
         walk(std::span(nodes_), TreeChild::node(0),
              TreeRay(tree_axes(way.origin, way.inverse, way.blur)), way.clock, to, consider);
}

extern template class BoundsTree<float>;
extern template class BoundsTree<double>;
#if ALHAZEN_HAS_QUAD
extern template class BoundsTree<Quad>;
#endif

}  // namespace alhazen::render
