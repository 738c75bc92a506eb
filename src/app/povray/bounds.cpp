#include "app/povray/bounds.h"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "core/base/overloaded.h"

namespace alhazen {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Bounds kNothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

Bounds around(std::initializer_list<Vec3d> points) {
  Bounds bounds = kNothing;
  for (const Vec3d p : points)
    bounds.add(p);
  return bounds;
}

// Of two balls, which hold a cylinder's or a cone's ends.
Bounds around_ends(Vec3d a, double radius_a, Vec3d b, double radius_b) {
  const Vec3d ra{radius_a, radius_a, radius_a}, rb{radius_b, radius_b, radius_b};
  return around({a - ra, a + ra, b - rb, b + rb});
}

}  // namespace

void Bounds::add(Vec3d p) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], p[i]);
    high[i] = std::max(high[i], p[i]);
  }
}

Bounds object_bounds(const Geometry& geometry) {
  return std::visit(
      Overloaded{
          [](const Sphere& s) { return around_ends(s.center, s.radius, s.center, s.radius); },
          [](const Plane&) {
            return Bounds{kNothing.high, kNothing.low};
          },
          [](const Box& b) {
            return Bounds{b.min, b.max};
          },
          [](const Disc& d) { return around_ends(d.center, d.radius, d.center, d.radius); },
          [](const Cylinder& c) { return around_ends(c.base, c.radius, c.top, c.radius); },
          [](const Cone& c) { return around_ends(c.base, c.base_radius, c.top, c.top_radius); },
          [](const Triangle& t) {
            return around({t.corners[0], t.corners[1], t.corners[2]});
          },
          [](const Quad4& q) {
            return around({q.corner, q.corner + q.edge_u, q.corner + q.edge_v,
                           q.corner + q.edge_u + q.edge_v});
          }},
      geometry);
}

Bounds world_bounds(const Shape& shape) {
  const Bounds object = object_bounds(shape.geometry);
  if (!shape.world_from_object || !is_finite(object.low)) return object;
  Bounds world = kNothing;
  for (int corner = 0; corner < 8; ++corner) {
    world.add(shape.world_from_object->point({(corner & 1) != 0 ? object.high.x : object.low.x,
                                              (corner & 2) != 0 ? object.high.y : object.low.y,
                                              (corner & 4) != 0 ? object.high.z : object.low.z}));
  }
  return world;
}

double extent(const Bounds& bounds) {
  const Vec3d edges = bounds.high - bounds.low;
  return std::max({edges.x, edges.y, edges.z});
}

}  // namespace alhazen
