// render/accel: which surface a ray meets first, by a tree over the shapes of a table. The same
// hits, to the last bit, as asking every shape (closest_hit.h); why is in docs/acceleration.md.
#pragma once

#include "render/accel/bounds_tree.h"
#include "render/accel/hit.h"

namespace alhazen::render {

// Of the shapes that no other stands in for (shape/twins.h). The table stays where it is and lives
// longer.
template <class Real>
class ShapeTree : public BoundsTree<Real> {
 public:
  explicit ShapeTree(const ShapeTable<Real>& table, int threads = 1)
      : BoundsTree<Real>(
            table.size(), [&table](ShapeId id) { return table.bounds(id); },
            [&table](ShapeId id) { return !table.twins().is_hidden(id); }, threads),
        table_(&table) {}

  const ShapeTable<Real>& table() const { return *table_; }

 private:
  const ShapeTable<Real>* table_;
};

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
