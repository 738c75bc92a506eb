#include "app/povray/nesting.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/overloaded.h"

namespace alhazen {
namespace {

struct Bounds {
  Vec3d low, high;

  void add(Vec3d p) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
};

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

bool overlap(const Bounds& a, const Bounds& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  }
  return true;
}

bool is_see_through(const Material& material) {
  return std::visit(Overloaded{[](const Glass&) { return true; },
                               [](const PovFinish& m) {
                                 return m.filter + m.transmit > 0 && m.reflection.fresnel;
                               },
                               [](const auto&) { return false; }},
                    material.scattering);
}

struct Solid {
  Bounds bounds;
  MaterialId material;
  SourceSpan span;
  bool found = false;
};

}  // namespace

std::vector<SourceSpan> solids_within_solids(const Scene& scene) {
  std::vector<Solid> solids;
  for (const Shape& shape : scene.shapes) {
    if (!is_see_through(scene.materials[shape.material])) continue;
    solids.push_back({world_bounds(shape), shape.material, shape.span});
  }
  // Along x only those are compared that overlap there.
  std::ranges::stable_sort(solids, {}, [](const Solid& s) { return s.bounds.low.x; });
  std::vector<SourceSpan> found;
  for (auto a = solids.begin(); a != solids.end(); ++a) {
    for (auto b = a + 1; b != solids.end() && b->bounds.low.x <= a->bounds.high.x; ++b) {
      if ((a->found && b->found) || a->material == b->material || !overlap(a->bounds, b->bounds))
        continue;
      for (Solid* solid : {&*a, &*b}) {
        if (std::exchange(solid->found, true)) continue;
        if (std::ranges::find(found, solid->span) == found.end()) found.push_back(solid->span);
      }
    }
  }
  return found;
}

}  // namespace alhazen
