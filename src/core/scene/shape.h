// core/scene: shapes as plain data. Each is given in its own object frame; `world_from_object`
// places it. Lengths have no unit. The kernels (render/shape) say how each is intersected.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/diag/source.h"
#include "core/math/transform.h"

namespace alhazen {

using MaterialId = std::uint32_t;
using ShapeId = std::uint32_t;  // which of Scene::shapes it is
using LightId = std::uint32_t;
inline constexpr std::uint32_t kNoId = ~std::uint32_t{0};

struct Sphere {
  Vec3d center;
  double radius = 1;  // > 0
};
// All points p with dot(normal, p) = offset; the inside of a solid plane is below, dot < offset.
struct Plane {
  Vec3d normal{0, 1, 0};  // unit length to rounding
  double offset = 0;
};
struct Box {
  Vec3d min, max;  // min < max in every component
};
// Points of the plane through `center` whose distance from it lies in [hole_radius, radius].
struct Disc {
  Vec3d center, normal;  // unit length to rounding
  double radius = 1, hole_radius = 0;
};
struct Cylinder {
  Vec3d base, top;  // centres of the end discs; different
  double radius = 1;
  bool capped = true;
};
// A frustum; one of the radii may be 0 (a pointed cone), and they may be equal (then a cylinder).
struct Cone {
  Vec3d base, top;
  double base_radius = 1, top_radius = 0;
  bool capped = true;
};
// The geometric normal is cross(b - a, c - a), normalised, in a left-handed frame as it comes out.
// `normals`, unit length, interpolate to the shading normal.
struct Triangle {
  std::array<Vec3d, 3> corners;
  std::optional<std::array<Vec3d, 3>> normals;
};
// The parallelogram corner + u edge_u + v edge_v with u, v in [0, 1]; normal cross(edge_u, edge_v).
struct Quad4 {
  Vec3d corner, edge_u, edge_v;
};

using Geometry = std::variant<Sphere, Plane, Box, Disc, Cylinder, Cone, Triangle, Quad4>;

// Whether the surface bounds a solid, so that an inside exists.
bool is_closed(const Geometry& geometry);
const char* kind_name(const Geometry& geometry);

struct Shape {
  Geometry geometry;
  // Nothing means the identity: the object frame is the world. Never singular.
  std::optional<Affined> world_from_object;
  MaterialId material = kNoId;
  LightId light = kNoId;  // the light whose visible surface this is
  // What the author called it, after the names of the groups around it: "table/top". Of a numbered
  // shape those of the groups alone, "table/"; its kind and number complete it (ShapeList::name).
  std::string name;
  SourceSpan span;
  ShapeId number = 0;  // among those of its kind, from 1, where the author gave no name; else 0
};

}  // namespace alhazen
