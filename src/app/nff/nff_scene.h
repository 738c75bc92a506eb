// app/nff: what a file of Haines's Neutral File Format says, as plain data in NFF's own
// right-handed frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/math/vec.h"

namespace alhazen {

struct NffView {
  Vec3d from, at, up;
  // In degrees, between the centres of the top and the bottom row of pixels; in a square picture
  // also between those of the left and the right column.
  double angle = 0;
  int width = 0, height = 0;
};

struct NffLight {
  Vec3d position;
  std::optional<Rgbd> color;
};

struct NffFill {
  Rgbd color;
  double diffuse = 0, specular = 0, shine = 0;  // Kd, Ks and the exponent of the highlight
  double transmittance = 0, ior = 0;            // T; `ior` is 0 or less where nothing is refracted
  std::uint32_t line = 0;                       // where it was first written
};

struct NffSphere {
  Vec3d center;
  double radius = 0;
};
// Open at both ends; at most one radius is 0.
struct NffCone {
  Vec3d base;
  double base_radius = 0;
  Vec3d apex;
  double apex_radius = 0;
};
// Of a polygon or a patch; the front is where the corners run counterclockwise.
struct NffTriangle {
  std::array<Vec3d, 3> corners;
  std::optional<std::array<Vec3d, 3>> normals;  // of any length but 0
};
using NffShape = std::variant<NffSphere, NffCone, NffTriangle>;

// Shapes that follow each other in the file and have one fill, an index into NffScene::fills.
struct NffRun {
  std::size_t fill = 0;
  std::vector<NffShape> shapes;
};

// How many of each entity the file has; polygons before they were cut into triangles.
struct NffCounts {
  std::size_t spheres = 0, cones = 0, polygons = 0, patches = 0;
  std::size_t triangles = 0;  // that polygons and patches became
};

struct NffScene {
  NffView view;
  Rgbd background;
  std::vector<NffLight> lights;
  std::vector<NffFill> fills;  // each once, and only those that a shape wears
  std::vector<NffRun> runs;
  NffCounts counts;
};

}  // namespace alhazen
