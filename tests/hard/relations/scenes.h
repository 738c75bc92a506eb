// tests/hard/relations: scenes that can be put anywhere: enlarged, moved, turned, mirrored, with
// their shapes in another order. All coordinates are multiples of 1/64, so that moves by larger
// powers of two are exact. No textures: a checker's edge is a decision that no signature holds.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "support/scene_builder.h"

namespace alhazen::hard {

// A point p of the scene stands at scale * (p.x axes[0] + p.y axes[1] + p.z axes[2]) + move.
struct Place {
  double scale = 1;
  Vec3d move;
  std::array<Vec3d, 3> axes{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  bool shapes_reversed = false, lights_reversed = false;  // in the opposite order

  Vec3d vector(Vec3d v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
  Vec3d length_of(Vec3d v) const { return scale * vector(v); }
  Vec3d point(Vec3d p) const { return length_of(p) + move; }
};

class PlacedScene {
 public:
  explicit PlacedScene(const Place& place) : place_(place) {
    b_.scene.settings.width = 24;
    b_.scene.settings.height = 18;
    b_.scene.settings.max_depth = 6;
    b_.background(0.25);
  }

  testing::SceneBuilder& materials() { return b_; }
  void sphere(Vec3d center, double radius, MaterialId worn) {
    b_.add(Sphere{place_.point(center), place_.scale * radius}, worn);
  }
  void box(Vec3d min, Vec3d max, MaterialId worn) {
    const Vec3d a = place_.point(min), b = place_.point(max);
    Box placed;
    for (int i = 0; i < 3; ++i) {
      placed.min[i] = std::min(a[i], b[i]);
      placed.max[i] = std::max(a[i], b[i]);
    }
    b_.add(placed, worn);
  }
  void cylinder(Vec3d base, Vec3d top, double radius, MaterialId worn) {
    b_.add(Cylinder{place_.point(base), place_.point(top), place_.scale * radius, true}, worn);
  }
  void cone(Vec3d base, Vec3d top, double radius, MaterialId worn) {
    b_.add(Cone{place_.point(base), place_.point(top), place_.scale * radius, 0, true}, worn);
  }
  void quad(Vec3d corner, Vec3d u, Vec3d v, MaterialId worn) {
    b_.add(Quad4{place_.point(corner), place_.length_of(u), place_.length_of(v)}, worn);
  }
  MaterialId glass(double ior, double absorption) {
    return b_.glass(ior, Rgbd(absorption / place_.scale));
  }
  void point_light(Vec3d position, double intensity) {
    b_.light(PointLight{place_.point(position), Rgbd(place_.scale * place_.scale * intensity),
                        Falloff::inverse_square});
  }
  void directional_light(Vec3d direction, double irradiance) {
    b_.light(DirectionalLight{normalized(place_.vector(direction)), Rgbd(irradiance)});
  }
  void spot_light(Vec3d position, Vec3d axis, double intensity) {
    b_.light(SpotLight{place_.point(position), normalized(place_.vector(axis)),
                       Rgbd(place_.scale * place_.scale * intensity), 25, 40,
                       Falloff::inverse_square});
  }
  // Looks along +z.
  void look(Vec3d position, double fov_deg) {
    b_.scene.camera.frame = {place_.point(position), place_.vector({1, 0, 0}),
                             place_.vector({0, 1, 0}), place_.vector({0, 0, 1})};
    b_.scene.camera.projection = PerspectiveCamera{fov_deg, std::nullopt};
  }
  Scene finish() {
    if (place_.shapes_reversed) {
      std::vector<Shape> shapes(b_.scene.shapes.begin(), b_.scene.shapes.end());
      std::reverse(shapes.begin(), shapes.end());
      b_.scene.shapes = shapes;
    }
    if (place_.lights_reversed) std::reverse(b_.scene.lights.begin(), b_.scene.lights.end());
    return std::move(b_.scene);
  }

 private:
  Place place_;
  testing::SceneBuilder b_;
};

// Glass in glass, a glass box, a matte ball seen through them.
inline Scene glass_scene(const Place& place = {}) {
  PlacedScene s(place);
  auto& b = s.materials();
  s.box({-8, -2, -8}, {8, -1.03125, 8}, b.diffuse(0.7));
  s.sphere({-0.75, 0, 1}, 1, s.glass(1.5, 0.25));
  s.sphere({-0.75, 0.125, 1}, 0.5, s.glass(1.25, 0.5));
  s.box({0.5, -1, 0.5}, {1.5, 0.5, 1.75}, s.glass(1.625, 0.125));
  s.cylinder({2, -0.75, 3}, {2.25, 1, 3.25}, 0.5, s.glass(1.375, 0));
  s.sphere({0.25, 0.25, 4}, 1, b.diffuse(0.5));
  s.point_light({4, 6, -4}, 90);
  s.look({0.015625, 0.53125, -5}, 45);
  return s.finish();
}

// Mirrors that see each other.
inline Scene mirror_scene(const Place& place = {}) {
  PlacedScene s(place);
  auto& b = s.materials();
  s.box({-8, -2, -8}, {8, -1.03125, 8}, b.mirror(0.5));
  s.quad({-3, -1, 3}, {6, 0.25, 1}, {0, 4, -0.5}, b.mirror(0.875));
  s.sphere({-1, 0, 1}, 0.875, b.mirror(0.75));
  s.sphere({1.03125, 0.25, 0.5}, 0.75, b.mirror(0.625));
  s.cone({0.25, -1, -0.5}, {0.25, 0.25, -0.5}, 0.375, b.diffuse(0.75));
  s.point_light({4, 6, -4}, 90);
  s.directional_light({-1, -2, 1}, 0.5);
  s.look({0.015625, 0.53125, -5}, 50);
  return s.finish();
}

// Matte things of each shape and many lights: thousands of shadow decisions.
inline Scene light_scene(const Place& place = {}) {
  PlacedScene s(place);
  auto& b = s.materials();
  s.box({-8, -2, -8}, {8, -1.03125, 8}, b.diffuse(0.7));
  s.sphere({-1.5, 0, 1}, 0.875, b.diffuse(0.6));
  s.box({0.25, -0.9375, 0.5}, {1.25, 0.25, 1.5}, b.diffuse(0.5));
  s.cylinder({2, -1, 0}, {2.125, 0.5, 0.25}, 0.375, b.diffuse(0.8));
  s.cone({-0.25, -1, -1}, {-0.25, 0.125, -1}, 0.375, b.diffuse(0.75));
  s.quad({-3, -1, 3}, {6, 0.25, 1}, {0, 4, -0.5}, b.diffuse(0.4));
  for (int i = 0; i < 12; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    s.point_light({side * (1 + 0.375 * i), 2.5 + 0.25 * i, -4 + 0.4375 * i}, 8);
  }
  s.directional_light({-1, -2, 1}, 0.5);
  s.directional_light({2, -1, 0.5}, 0.25);
  s.spot_light({1, 5, -3}, {-0.25, -1, 0.5}, 20);
  s.look({0.015625, 0.53125, -5}, 50);
  return s.finish();
}

struct NamedScene {
  std::string_view name;
  Scene (*at)(const Place&);
};
inline constexpr NamedScene kScenes[] = {
    {"glass", glass_scene}, {"mirrors", mirror_scene}, {"lights", light_scene}};

}  // namespace alhazen::hard
