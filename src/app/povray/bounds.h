// app/povray: boxes along the axes around shapes.
#pragma once

#include "core/scene/shape.h"

namespace alhazen {

struct Bounds {
  Vec3d low, high;

  void add(Vec3d p);
};

// In the shape's own frame; may be larger than need be. A plane's is all of space.
Bounds object_bounds(const Geometry& geometry);
Bounds world_bounds(const Shape& shape);
// The longest edge.
double extent(const Bounds& bounds);

}  // namespace alhazen
