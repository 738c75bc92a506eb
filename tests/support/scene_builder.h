// tests/support: scenes made in a line or two, for tests of the renderer.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/scene/scene.h"

namespace alhazen::testing {

class SceneBuilder {
 public:
  SceneBuilder() {
    scene.settings.width = scene.settings.height = 16;
    scene.settings.samples = 1;
    scene.settings.cutoff = 0;
    scene.background.source = SolidBackground{};
  }

  TextureId color(Rgbd value) {
    scene.textures.push_back({SolidPattern{value}, Mapping::object, Affined(), {}});
    return static_cast<TextureId>(scene.textures.size() - 1);
  }
  MaterialId material(Scattering scattering, Rgbd emission = {}) {
    scene.materials.push_back({std::move(scattering), emission, false, "", {}});
    return static_cast<MaterialId>(scene.materials.size() - 1);
  }
  MaterialId diffuse(double albedo) { return material(Diffuse{color(Rgbd(albedo)), {}}); }
  MaterialId mirror(double reflectance) { return material(Mirror{color(Rgbd(reflectance))}); }
  MaterialId glass(double ior, Rgbd absorption = {}, int priority = 0) {
    return material(Glass{ior, absorption, priority});
  }
  ShapeId add(Geometry geometry, MaterialId worn) {
    scene.shapes.push_back({std::move(geometry), std::nullopt, worn, kNoId, "", {}});
    return static_cast<ShapeId>(scene.shapes.size() - 1);
  }
  // `change(Shape&)` makes the shape another one.
  template <class Change>
  void change(ShapeId id, Change change) {
    std::vector<Shape> shapes(scene.shapes.begin(), scene.shapes.end());
    change(shapes[id]);
    scene.shapes = shapes;
  }
  void light(LightSource source) {
    scene.lights.push_back({std::move(source), true, kNoId, "", {}});
  }
  // A lamp that is seen.
  void visible_light(const RectangleLight& lamp) {
    const MaterialId worn = material(Black{}, lamp.radiance);
    scene.materials.back().one_sided_emission = true;
    const ShapeId shape = add(Quad4{lamp.corner, lamp.edge_u, lamp.edge_v}, worn);
    const auto light = static_cast<LightId>(scene.lights.size());
    change(shape, [light](Shape& lit) { lit.light = light; });
    scene.lights.push_back({lamp, true, shape, "", {}});
  }
  void background(double radiance) { scene.background.source = SolidBackground{Rgbd(radiance)}; }

  // A camera at `position` that looks along `forward` with `up` above; both of unit length and
  // perpendicular to each other.
  void look(Vec3d position, Vec3d forward, Vec3d up, double fov_deg) {
    scene.camera.frame = {position, cross(up, forward), up, forward};
    scene.camera.projection = PerspectiveCamera{fov_deg, std::nullopt};
  }

  Scene scene;
};

}  // namespace alhazen::testing
