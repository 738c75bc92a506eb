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
  const ShapeTable<double> shapes(scene.shapes, scene.camera.frame.position);
  for (ShapeId id = 0; id < scene.shapes.size(); ++id) {
    const Shape& shape = scene.shapes[id];
    const Scattering& scattering = scene.materials[shape.material].scattering;
    // In POV-Ray one is inside of opaque solids too, which matters to Fresnel's reflection.
    const bool has_inside =
        std::holds_alternative<Glass>(scattering) || std::holds_alternative<PovFinish>(scattering);
    if (has_inside && is_closed(shape.geometry) && may_start_in(scene, shapes, id)) {
      effects.call(Effect::camera_in_glass, shape.span);
    }
  }
  return effects;
}

}  // namespace alhazen::render
