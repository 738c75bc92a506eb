// render/shape: the renderer's own copy of the scene's shapes: one array per kind, in the scalar
// type of the run, seen from the camera.
//
// The world frame here is the scene's, moved by `world_origin` (the camera): points near the viewer
// have small coordinates, and a scene moved as a whole gives the same bits (docs/numerics.md, 5.2).
// Kinds that stay what they are under an affine map (plane, triangle, quad) are mapped when the
// table is made; the others keep their object frame and have the ray mapped instead, so that t is
// the same in both frames.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "core/scene/shape_list.h"
#include "render/shape/bounds.h"
#include "render/shape/convert.h"
#include "render/shape/doubt.h"
#include "render/shape/kernel_arrays.h"
#include "render/shape/laid.h"
#include "render/shape/normal_map.h"
#include "render/shape/twins.h"

namespace alhazen::render {

template <class Real>
struct SurfacePoint : Surface<Real> {
  // The same point in the shape's object frame as the scene gave it, where patterns live.
  Vec3<Real> object_position;
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline SurfacePoint<Real> select(
    MaskOf<Real> which, const SurfacePoint<Real>& yes, const SurfacePoint<Real>& no) {
  const Surface<Real>&yes_base = yes, &no_base = no;
  return {select(which, yes_base, no_base), select(which, yes.object_position, no.object_position)};
}

// A point that a kernel found in the object frame. Smooth triangles have been mapped beforehand, so
// the normal is the shading normal.
template <class Real>
inline SurfacePoint<Real> out_of_object(const Surface<Real>& own, const Placement<Real>& place) {
  Surface<Real> point = own;
  point.position = place.world_from_object.point(own.position);
  point.normal = normal_in_world(place.world_from_object, place.object_from_world, own.normal);
  point.shading_normal = point.normal;
  return {point, own.position};
}

template <class Real>
class ShapeTable {
 public:
  // Shapes keep their order: a ShapeId here is one in the scene. Of those that are one surface, the
  // one of the lowest rank(shape) is outermost; without ranks, the first.
  ShapeTable(const ShapeList& shapes, Vec3d world_origin,
             const std::function<int(ShapeId)>& rank = {}, double reach = 0);
  // In the frame that they are given in, to rays from as far away as `reach`.
  explicit ShapeTable(const ShapeList& shapes, double reach = 0)
      : ShapeTable(shapes, Vec3d(), {}, reach) {}

  ShapeId size() const { return static_cast<ShapeId>(entries_.size()); }
  // What was subtracted: scene position = position + world_origin.
  Vec3<Real> world_origin() const { return world_origin_; }
  // Those that are one surface with another. Every function here is of the shape itself.
  const Twins& twins() const { return twins_; }
  // By what a quad or a disc was moved because it lies on another shape (laid.h); mostly nothing.
  Vec3<Real> lift(ShapeId id) const {
    const auto laid = laid_.find(id);
    return laid == laid_.end() ? Vec3<Real>() : laid->second;
  }
  // By what a lamp that is no shape has to be moved in order to lie on the shapes. Its corners are
  // in the moved world frame, its light goes to where cross(1 - 0, 3 - 0) points.
  Vec3<Real> lift_of_lamp(const std::array<Vec3<Real>, 4>& corners) const;

  // Rays, points and normals are in the moved world frame. L is Real, or lanes of it.

  // Of rays from elsewhere with one shape.
  template <class L>
  CrossingPair<L> crossings(ShapeId id, const Ray<L>& ray) const {
    return crossings_of(entries_[id], ray);
  }
  // The same of rays that have been made ready for many triangles and quads.
  template <class L>
  CrossingPair<L> crossings(ShapeId id, const ShearedRay<L>& ray) const {
    return crossings_of(entries_[id], ray);
  }
  Crossings<Real> crossings(ShapeId id, const Ray<Real>& ray, Departure from) const;
  // Each of the active lanes with the shape whose surface it leaves.
  template <class L>
  CrossingPair<L> own_crossings(const IntOf<L>& shape, const Ray<L>& ray, const IntOf<L>& face,
                                const IntOf<L>& side, const MaskOf<L>& active) const;
  // The same crossings and the near misses, each with its margin.
  Doubts<Real> doubts(ShapeId id, const Ray<Real>& ray, Departure from) const;

  SurfacePoint<Real> surface(ShapeId id, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) const;
  // The same without u and v, whose arcs can cost more than all the rest.
  SurfacePoint<Real> plain_surface(ShapeId id, const Ray<Real>& ray,
                                   const Crossing<Real>& crossing) const;
  // Each of the active lanes on its own shape; the others have no meaning.
  template <class L>
  SurfacePoint<L> surface(const IntOf<L>& shape, const Ray<L>& ray, const Crossing<L>& crossing,
                          const MaskOf<L>& active) const;
  template <class L>
  SurfacePoint<L> plain_surface(const IntOf<L>& shape, const Ray<L>& ray,
                                const Crossing<L>& crossing, const MaskOf<L>& active) const;

  // Whether the point is inside of a closed shape; on the surface it is not. Open shapes contain
  // nothing.
  bool contains(ShapeId id, Vec3<Real> point) const;
  // Nothing for a plane, which has no bounds.
  std::optional<ShapeBounds<Real>> bounds(ShapeId id) const;
  Landmarks<Real> landmarks(ShapeId id) const;

 private:
  class Builder;
  class Flats;

  void lay_sheets(const ShapeList& shapes, Real reach);
  void move(ShapeId sheet, Vec3<Real> shift);
  Ray<Real> own_ray(const Entry& entry, const Ray<Real>& ray) const;
  template <template <class> class RayKind, class L>
  CrossingPair<L> crossings_of(const Entry& entry, const RayKind<L>& ray) const {
    const auto with_kernel = [&](const auto& own) {
      return kernels_.visit(
          entry, [&](const auto& kernel) { return render::crossings(convert<L>(kernel), own); });
    };
    if (!entry.in_object_frame) return with_kernel(ray);
    return with_kernel(convert<L>(placements_[entry.placement]).in_object(ray));
  }
  template <bool with_coordinates, class L>
  SurfacePoint<L> surface_of_one(const Entry& entry, const Ray<L>& ray,
                                 const Crossing<L>& crossing) const;
  template <bool with_coordinates, class L>
  SurfacePoint<L> surface_of_each(const IntOf<L>& shape, const Ray<L>& ray,
                                  const Crossing<L>& crossing, const MaskOf<L>& active) const;

  std::vector<Entry> entries_;
  std::vector<Placement<Real>> placements_;
  KernelArrays<Real> kernels_;
  Vec3<Real> world_origin_;
  Twins twins_;
  std::unordered_map<ShapeId, Vec3<Real>> laid_;
};

extern template class ShapeTable<float>;
extern template class ShapeTable<double>;
#if ALHAZEN_HAS_QUAD
extern template class ShapeTable<Quad>;
#endif

}  // namespace alhazen::render

#include "render/shape/shape_table_lanes.h"
