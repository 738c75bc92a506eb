// app/nff: plane polygons, concave ones too, cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace alhazen {

enum class PolygonKind {
  good,
  no_area,      // all its corners lie on one line, to rounding
  edges_cross,  // it is not simple: edges cross each other, or it turns back on itself
};

// Indices of three corners, in the order in which they run around the polygon.
using TriangleCorners = std::array<std::uint32_t, 3>;

// Appends the triangles that cover the polygon, each point of it once, to `triangles`; they have no
// other corners than the polygon's. It should be plane: what is not is cut as it looks along its
// average normal. Corners may repeat, and edges may touch, as in a polygon whose hole is joined to
// its rim by an edge there and back. A triangle that is a line to rounding is left out.
// Precondition: at least 3 corners, coordinates up to 1e100. Takes quadratic time.
PolygonKind triangulate(std::span<const Vec3d> corners, std::vector<TriangleCorners>& triangles);

}  // namespace alhazen
