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
#include <vector>

#include "core/math/transform.h"
#include "core/scene/shape.h"
#include "render/shape/bounds.h"
#include "render/shape/box.h"
#include "render/shape/disc.h"
#include "render/shape/doubt.h"
#include "render/shape/frustum.h"
#include "render/shape/parallelogram.h"
#include "render/shape/plane.h"
#include "render/shape/sphere.h"
#include "render/shape/triangle.h"

namespace alhazen::render {

template <class Real>
struct SurfacePoint : Surface<Real> {
  // The same point in the shape's object frame as the scene gave it, where patterns live.
  Vec3<Real> object_position;
};

template <class Real>
class ShapeTable {
 public:
  // Shapes keep their order: a ShapeId here is one in the scene.
  ShapeTable(const std::vector<Shape>& shapes, Vec3d world_origin);

  ShapeId size() const { return static_cast<ShapeId>(entries_.size()); }
  // What was subtracted: scene position = position + world_origin.
  Vec3<Real> world_origin() const { return world_origin_; }

  // Rays, points and normals are in the moved world frame.
  Crossings<Real> crossings(ShapeId id, const Ray<Real>& ray, Departure from) const;
  // The same crossings and the near misses, each with its margin.
  Doubts<Real> doubts(ShapeId id, const Ray<Real>& ray, Departure from) const;
  SurfacePoint<Real> surface(ShapeId id, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) const;
  // The same without u and v, whose arcs can cost more than all the rest.
  SurfacePoint<Real> plain_surface(ShapeId id, const Ray<Real>& ray,
                                   const Crossing<Real>& crossing) const;
  // Whether the point is inside of a closed shape; on the surface it is not. Open shapes contain
  // nothing.
  bool contains(ShapeId id, Vec3<Real> point) const;
  // Nothing for a plane, which has no bounds.
  std::optional<ShapeBounds<Real>> bounds(ShapeId id) const;

 private:
  enum class Kind : std::uint8_t { sphere, plane, box, disc, frustum, triangle, parallelogram };
  struct Placement {
    Affine<Real> world_from_object, object_from_world;
  };
  struct Entry {
    Kind kind;
    bool in_object_frame;     // the ray has to be mapped
    std::uint32_t index;      // in the array of its kind
    std::uint32_t placement;  // kNoId: the object frame is the scene's world
  };

  class Builder;
  Ray<Real> own_ray(const Entry& entry, const Ray<Real>& ray) const;
  template <bool with_coordinates>
  SurfacePoint<Real> find_surface(ShapeId id, const Ray<Real>& ray,
                                  const Crossing<Real>& crossing) const;
  template <class Visitor>
  auto visit(const Entry& entry, const Visitor& visitor) const;

  std::vector<Entry> entries_;
  std::vector<Placement> placements_;
  std::vector<Sphere<Real>> spheres_;
  std::vector<Plane<Real>> planes_;
  std::vector<Box<Real>> boxes_;
  std::vector<Disc<Real>> discs_;
  std::vector<Frustum<Real>> frusta_;
  std::vector<Triangle<Real>> triangles_;
  std::vector<Parallelogram<Real>> parallelograms_;
  Vec3<Real> world_origin_;
};

extern template class ShapeTable<float>;
extern template class ShapeTable<double>;
#if ALHAZEN_HAS_QUAD
extern template class ShapeTable<Quad>;
#endif

}  // namespace alhazen::render
