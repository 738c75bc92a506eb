// render/accel: which surface a ray meets first, by a tree of boxes: a bounding volume hierarchy.
// The same hits, to the last bit, as asking every shape (closest_hit.h); why is in
// docs/acceleration.md.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/accel/hit.h"
#include "render/accel/tree_approach.h"

namespace alhazen::render {

// The table stays where it is and lives longer.
template <class Real>
class ShapeTree {
 public:
  // The same tree for any number of threads.
  explicit ShapeTree(const ShapeTable<Real>& table, int threads = 1);

  const ShapeTable<Real>& table() const { return *table_; }
  // Shapes that every ray is tested against, and what is met by way of the others.
  std::span<const ShapeId> outside() const { return outside_; }
  std::span<const TreeNode> nodes() const { return nodes_; }
  const TreeFrame<Real>& frame() const { return frame_; }
  // Of the tree alone, without the table.
  std::size_t bytes() const;

  // Calls consider(id) for every shape that the ray may meet with from <= t <= to, and for others,
  // until it returns false. `to` is read anew each time. The shape that the ray leaves comes first.
  // Only shapes that no other stands in for are in the tree, and only such may be named.
  template <class Consider>
  void visit(const Ray<Real>& ray, const Source& source, Real from, const Real& to, ShapeId ignored,
             const Consider& consider) const;

 private:
  const ShapeTable<Real>* table_;
  std::vector<TreeNode> nodes_;
  std::vector<ShapeId> outside_;  // planes, and what has no useful bounds
  TreeFrame<Real> frame_;
};

extern template class ShapeTree<float>;
extern template class ShapeTree<double>;
#if ALHAZEN_HAS_QUAD
extern template class ShapeTree<Quad>;
#endif

// As the functions of the same names in closest_hit.h.
template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored = kNoId);
template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored = kNoId);
template <class Real>
bool any_hit(const ShapeTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored = kNoId);

}  // namespace alhazen::render
