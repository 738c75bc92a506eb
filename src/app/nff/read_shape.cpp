// app/nff: the entities s, c, p and pp.
#include <cmath>
#include <fmt/format.h>

#include "app/nff/direction.h"
#include "app/nff/reader.h"
#include "app/nff/triangulate.h"

namespace alhazen {

bool NffReader::inside_out(bool negative) {
  if (negative) inside_out_.note(keyword_.span);
  return negative;
}

//   s  center.x center.y center.z radius
bool NffReader::sphere() {
  check_fill();
  NffSphere sphere;
  if (!vector({"the centre"}, sphere.center) || !number({"the radius"}, sphere.radius)) {
    return false;
  }
  if (sphere.radius == 0) return out_of_range({"the radius"}, "not 0");
  inside_out(sphere.radius < 0);
  sphere.radius = std::fabs(sphere.radius);
  ++scene_.counts.spheres;
  add(sphere);
  return true;
}

//   c  base.x base.y base.z base_radius  apex.x apex.y apex.z apex_radius
bool NffReader::cone() {
  check_fill();
  NffCone cone;
  if (!vector({"the base"}, cone.base) || !number({"the base radius"}, cone.base_radius) ||
      !vector({"the apex"}, cone.apex) || !number({"the apex radius"}, cone.apex_radius)) {
    return false;
  }
  if (cone.base_radius == 0 && cone.apex_radius == 0) {
    return out_of_range({"the apex radius"}, "not 0 where the base radius is");
  }
  if ((cone.base_radius < 0 && cone.apex_radius > 0) ||
      (cone.base_radius > 0 && cone.apex_radius < 0)) {
    return out_of_range({"the apex radius"}, "of the same sign as the base radius");
  }
  if (cone.base == cone.apex) {
    sink_.report<DiagnosticKind::import_no_direction>(keyword_.span,
                                                      "the base of `c` is the same point as its "
                                                      "apex");
    return false;
  }
  inside_out(cone.base_radius < 0 || cone.apex_radius < 0);
  cone.base_radius = std::fabs(cone.base_radius);
  cone.apex_radius = std::fabs(cone.apex_radius);
  ++scene_.counts.cones;
  add(cone);
  return true;
}

//   p  count  x y z  x y z  ...
bool NffReader::polygon() {
  ++scene_.counts.polygons;
  return faces(false);
}

//   pp  count  x y z  normal.x normal.y normal.z  ...
bool NffReader::patch() {
  ++scene_.counts.patches;
  return faces(true);
}

bool NffReader::faces(bool with_normals) {
  check_fill();
  std::size_t count = 0;
  if (!whole({"the number of vertices"}, 3, limits_.polygon_vertices, count)) return false;
  std::vector<Vec3d> corners, normals;
  if (!vertices(count, with_normals, corners, normals)) return false;
  std::vector<TriangleCorners> triangles;
  switch (triangulate(corners, triangles)) {
    case PolygonKind::good:
      break;
    case PolygonKind::no_area:
      no_area_.note(keyword_.span);
      return true;
    case PolygonKind::edges_cross:
      sink_.report<DiagnosticKind::import_edges_cross>(keyword_.span);
      return true;
  }
  scene_.counts.triangles += triangles.size();
  for (const auto& [a, b, c] : triangles) {
    NffTriangle triangle{{corners[a], corners[b], corners[c]}, std::nullopt};
    if (with_normals) triangle.normals = {normals[a], normals[b], normals[c]};
    add(triangle);
  }
  return true;
}

bool NffReader::vertices(std::size_t count, bool with_normals, std::vector<Vec3d>& corners,
                         std::vector<Vec3d>& normals) {
  for (std::size_t i = 1; i <= count; ++i) {
    if (!vector({"vertex", i}, corners.emplace_back())) return false;
    if (!with_normals) continue;
    if (!vector({"normal", i}, normals.emplace_back())) return false;
    if (is_zero(normals.back())) return out_of_range({"normal", i}, "not zero");
  }
  return true;
}

void NffReader::check_fill() {
  if (fill_ || before_fill_reported_) return;
  before_fill_reported_ = true;
  sink_.report<DiagnosticKind::import_before_fill>(keyword_.span, keyword_.text)
      .hint("write the colour first: `f red green blue Kd Ks Shine T index_of_refraction`");
}

void NffReader::add(NffShape shape) {
  if (!fill_ || too_many_) return;
  const std::size_t fill = fill_index();
  if (scene_.runs.empty() || scene_.runs.back().fill != fill) scene_.runs.push_back({fill, {}});
  scene_.runs.back().shapes.push_back(shape);
  ++shape_count_;
  too_many_ = shape_count_ + scene_.runs.size() + scene_.lights.size() > limits_.shapes;
}

std::size_t NffReader::fill_index() {
  if (fill_index_) return *fill_index_;
  const NffFill& f = *fill_;
  const auto [known, is_new] = known_fills_.try_emplace(
      {f.color.r, f.color.g, f.color.b, f.diffuse, f.specular, f.shine, f.transmittance, f.ior},
      scene_.fills.size());
  if (is_new) scene_.fills.push_back(f);
  fill_index_ = known->second;
  return known->second;
}

}  // namespace alhazen
