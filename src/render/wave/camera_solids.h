// render/wave: the solids that a camera ray may start inside of.
#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "render/shape/world_shapes.h"

namespace alhazen::render {

// A box around all the points that camera rays start from, by its half sides; the camera is in its
// middle. It is twice as large as it has to be, so that no rounding takes a ray out of it.
Vec3d reach_of_starts(const Scene& scene);

// Whether the solid may hold a point of that box.
bool may_hold_start(const WorldShapes<double>& shapes, ShapeId solid, Vec3d half);

// In the order of their ids: the closed shapes whose material fills them, single ones and those of
// instances whose bounds reach the camera.
template <class Real>
std::vector<ShapeId> clear_solids(const Scene& scene, const WorldShapes<Real>& shapes);

}  // namespace alhazen::render
