// render/shape: the scene's shapes as kernels want them, in double. `place` says how the object
// frame lies in the world of the renderer.
#pragma once

#include "core/scene/shape.h"
#include "render/shape/box.h"
#include "render/shape/disc.h"
#include "render/shape/frustum.h"
#include "render/shape/parallelogram.h"
#include "render/shape/plane.h"
#include "render/shape/sphere.h"
#include "render/shape/triangle.h"

namespace alhazen::render {

// Kinds that keep their object frame. `origin` is subtracted from their points.
Sphere<double> from_scene(const alhazen::Sphere& sphere, Vec3d origin);
Box<double> from_scene(const alhazen::Box& box, Vec3d origin);
Disc<double> from_scene(const alhazen::Disc& disc, Vec3d origin);
Frustum<double> from_scene(const alhazen::Cylinder& cylinder, Vec3d origin);
Frustum<double> from_scene(const alhazen::Cone& cone, Vec3d origin);

// Kinds that are mapped into the world of the renderer.
struct Placed {
  Affined world_from_object, object_from_world;
  bool mirrored;  // the determinant is negative
};
// A placement of the scene, which promises that it is not singular, as seen from `origin`.
Placed placed(Affined world_from_object, Vec3d origin);
Plane<double> from_scene(const alhazen::Plane& plane, Vec3d origin);
Plane<double> from_scene(const alhazen::Plane& plane, const Placed& place);
Triangle<double> from_scene(const alhazen::Triangle& triangle, Vec3d origin);
Triangle<double> from_scene(const alhazen::Triangle& triangle, const Placed& place);
Parallelogram<double> from_scene(const Quad4& quad, Vec3d origin);
Parallelogram<double> from_scene(const Quad4& quad, const Placed& place);

}  // namespace alhazen::render
