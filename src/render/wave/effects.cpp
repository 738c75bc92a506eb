#include <algorithm>

#include "render/shape/shape_table.h"
#include "render/wave/plan.h"

namespace alhazen::render {
namespace {

// Rays through a pinhole start at one point; those of a lens or of a parallel camera at many, and
// then any solid may hold one.
bool may_start_in(const Scene& scene, const ShapeTable<double>& shapes, ShapeId solid) {
  const auto* perspective = std::get_if<PerspectiveCamera>(&scene.camera.projection);
  const bool pinhole =
      perspective && (!perspective->lens || perspective->lens->aperture_radius == 0);
  return !pinhole || shapes.contains(solid, Vec3d());
}

}  // namespace

EffectSet effects_of(const Scene& scene) {
  EffectSet effects = derive_effects(scene);
  if (!effects.has(Effect::refraction) && !effects.has(Effect::pov_transmission)) return effects;
  const auto solid = solid_colors(scene);
  const ShapeTable<double> shapes(scene.shapes, scene.camera.frame.position);
  for (ShapeId id = 0; id < scene.shapes.size(); ++id) {
    const Shape& shape = scene.shapes[id];
    const Scattering& scattering = scene.materials[shape.material].scattering;
    const auto* finish = std::get_if<PovFinish>(&scattering);
    const bool is_clear = std::holds_alternative<Glass>(scattering) ||
                          (finish != nullptr && lets_light_through(*finish, solid));
    if (is_clear && is_closed(shape.geometry) && may_start_in(scene, shapes, id)) {
      effects.call(Effect::camera_in_glass, shape.span);
    }
  }
  return effects;
}

}  // namespace alhazen::render
