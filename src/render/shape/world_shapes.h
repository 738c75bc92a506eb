// render/shape: all shapes of a scene by id: single ones, in a table measured from the camera, and
// those of instances, whose prototype has a table in its own frame. A ray is mapped into that frame
// and goes on there as any other; t is the same in both.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/scene/scene_shapes.h"
#include "render/shape/shape_table.h"

namespace alhazen::render {

template <class Real>
class WorldShapes {
 public:
  // Shapes keep their ids. `world_origin` and `rank` as for ShapeTable.
  WorldShapes(const SceneShapes& shapes, Vec3d world_origin,
              const std::function<int(ShapeId)>& rank = {});

  ShapeId size() const { return index_.size(); }
  const ShapeTable<Real>& singles() const { return singles_; }
  bool has_instances() const { return !placements_.empty(); }
  InstanceId instance_count() const { return index_.instance_count(); }
  std::span<const ShapeTable<Real>> prototypes() const { return prototypes_; }
  const Placement<Real>& placement(InstanceId id) const { return placements_[id]; }
  PrototypeId prototype_of(InstanceId id) const { return prototype_of_[id]; }
  // Of single shapes, and of the shapes of each instance. Those of two instances, or of an instance
  // and single, are each taken for a surface of its own.
  const Twins& twins() const { return has_instances() ? twins_ : singles_.twins(); }
  // As of ShapeTable, in the world frame.
  Vec3<Real> lift(ShapeId id) const;
  // Which shape of which table an id is.
  const InstanceIndex& index() const { return index_; }

  // As those of ShapeTable, by id; the rays, points and normals are in the moved world frame.
  Crossings<Real> crossings(ShapeId id, const Ray<Real>& ray, Departure from) const;
  Doubts<Real> doubts(ShapeId id, const Ray<Real>& ray, Departure from) const;
  SurfacePoint<Real> surface(ShapeId id, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) const;
  SurfacePoint<Real> plain_surface(ShapeId id, const Ray<Real>& ray,
                                   const Crossing<Real>& crossing) const;
  bool contains(ShapeId id, Vec3<Real> point) const;
  std::optional<ShapeBounds<Real>> bounds(ShapeId id) const;

  // Each of the active lanes with its own shape.
  template <class L>
  CrossingPair<L> own_crossings(const IntOf<L>& shape, const Ray<L>& ray, const IntOf<L>& face,
                                const IntOf<L>& side, const MaskOf<L>& active) const;
  template <class L>
  SurfacePoint<L> surface(const IntOf<L>& shape, const Ray<L>& ray, const Crossing<L>& crossing,
                          const MaskOf<L>& active) const;
  template <class L>
  SurfacePoint<L> plain_surface(const IntOf<L>& shape, const Ray<L>& ray,
                                const Crossing<L>& crossing, const MaskOf<L>& active) const;

 private:
  // work(table, number in it, placement or null).
  template <class Work>
  auto with_table(ShapeId id, const Work& work) const;
  // Calls work(table, numbers in it, placements or null, mask) for the active lanes of each table.
  template <class L, class Work>
  void for_each_table(const IntOf<L>& shape, const MaskOf<L>& active, const Work& work) const;
  template <bool with_coordinates, class L>
  SurfacePoint<L> surface_of_each(const IntOf<L>& shape, const Ray<L>& ray,
                                  const Crossing<L>& crossing, const MaskOf<L>& active) const;

  ShapeTable<Real> singles_;
  std::vector<ShapeTable<Real>> prototypes_;
  std::vector<Placement<Real>> placements_;  // of the instances
  std::vector<PrototypeId> prototype_of_;
  InstanceIndex index_;
  Twins twins_;  // by id
};

extern template class WorldShapes<float>;
extern template class WorldShapes<double>;
#if ALHAZEN_HAS_QUAD
extern template class WorldShapes<Quad>;
#endif

// A point that was found in the frame of a group. A bent shading normal is mapped on its own; no
// map, however skew, takes it below the surface.
template <class Real>
inline SurfacePoint<Real> out_of_group(const SurfacePoint<Real>& own,
                                       const Placement<Real>& place) {
  SurfacePoint<Real> point = own;
  point.position = place.world_from_object.point(own.position);
  point.normal = normal_in_world(place.world_from_object, place.object_from_world, own.normal);
  const Vec3<Real> shading =
      normal_in_world(place.world_from_object, place.object_from_world, own.shading_normal);
  point.shading_normal = select(dot(shading, point.normal) > Real(0), shading, point.normal);
  return point;
}

}  // namespace alhazen::render

#include "render/shape/world_shapes_lanes.h"
