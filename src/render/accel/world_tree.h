// render/accel: which surface of a scene a ray meets first: a tree over the single shapes, one over
// the instances, and one in the frame of each prototype. The same hits, to the last bit, as asking
// every shape of every instance (closest_hit.h).
#pragma once

#include "render/accel/shape_tree.h"
#include "render/shape/world_shapes.h"

namespace alhazen::render {

// The shapes stay where they are and live longer.
template <class Real>
class WorldTree {
 public:
  // The same for any number of threads.
  explicit WorldTree(const WorldShapes<Real>& shapes, int threads = 1);

  const WorldShapes<Real>& shapes() const { return *shapes_; }
  const ShapeTree<Real>& singles() const { return singles_; }
  const ShapeTree<Real>& prototype_of(InstanceId id) const {
    return prototypes_[shapes_->prototype_of(id)];
  }
  const BoundsTree<Real>& instances() const { return instances_; }
  // Of a single shape, where there are instances.
  ShapeId id_of_single(ShapeId number) const { return id_of_single_[number]; }
  // Of the trees alone.
  std::size_t bytes() const;

 private:
  static std::vector<ShapeTree<Real>> prototype_trees(const WorldShapes<Real>& shapes, int threads);
  std::optional<ShapeBounds<Real>> bounds_of(InstanceId id) const;

  const WorldShapes<Real>* shapes_;
  ShapeTree<Real> singles_;
  std::vector<ShapeTree<Real>> prototypes_;
  BoundsTree<Real> instances_;
  std::vector<ShapeId> id_of_single_;
};

extern template class WorldTree<float>;
extern template class WorldTree<double>;
#if ALHAZEN_HAS_QUAD
extern template class WorldTree<Quad>;
#endif

// As the functions of the same names in closest_hit.h.
template <class Real>
std::optional<Hit<Real>> closest_hit(const WorldTree<Real>& tree, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored = kNoId);
template <class Real>
std::optional<Hit<Real>> next_hit(const WorldTree<Real>& tree, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored = kNoId);
template <class Real>
bool any_hit(const WorldTree<Real>& tree, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored = kNoId);

}  // namespace alhazen::render
