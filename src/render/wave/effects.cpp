#include <algorithm>
#include <fmt/format.h>

#include "render/shape/shape_table.h"
#include "render/wave/plan.h"

namespace alhazen::render {
namespace {

// A box around all the points that camera rays start from, by its half sides; the camera is in its
// middle. It is twice as large as it has to be, so that no rounding takes a ray out of it.
Vec3d reach_of_starts(const Scene& scene) {
  const CameraFrame& frame = scene.camera.frame;
  double across = 0, upward = 0;
  if (const auto* parallel = std::get_if<OrthographicCamera>(&scene.camera.projection)) {
    const RenderSettings& settings = scene.settings;
    const double pixel = parallel->width / settings.width;
    across = pixel * (settings.width / 2.0 + settings.filter.radius);
    upward = pixel * (settings.height / 2.0 + settings.filter.radius);
  } else if (const auto& lens = std::get<PerspectiveCamera>(scene.camera.projection).lens) {
    across = upward = lens->aperture_radius;
  }
  Vec3d half;
  for (int i = 0; i < 3; ++i) {
    half[i] = 2 * (across * absolute(frame.right[i]) + upward * absolute(frame.up[i]));
  }
  return half;
}

// Whether the solid may hold a point of the box. Only of a half-space and a single point is more
// known than of their bounds.
bool may_hold_start(const ShapeTable<double>& shapes, ShapeId solid, Vec3d half) {
  if (half == Vec3d()) return shapes.contains(solid, half);
  const auto bounds = shapes.bounds(solid);
  if (!bounds) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3d start(corner & 1 ? -half.x : half.x, corner & 2 ? -half.y : half.y,
                        corner & 4 ? -half.z : half.z);
      if (shapes.contains(solid, start)) return true;
    }
    return false;
  }
  const double slack = bounds->reach * largest_coordinate(half);
  for (int i = 0; i < 3; ++i) {
    if (bounds->min[i] - slack > half[i] || bounds->max[i] + slack < -half[i]) return false;
  }
  return true;
}

}  // namespace

EffectSet effects_of(const Scene& scene, const PlanWants& wants) {
  EffectSet effects = derive_effects(scene, wants.albedo);
  if (!effects.has(Effect::refraction) && !effects.has(Effect::pov_transmission)) return effects;
  const ShapeTable<double> shapes(scene.shapes, scene.camera.frame.position);
  const Vec3d half = reach_of_starts(scene);
  for (ShapeId id = 0; id < scene.shapes.size(); ++id) {
    const Shape& shape = scene.shapes[id];
    const Scattering& scattering = scene.materials[shape.material].scattering;
    // In POV-Ray one is inside of opaque solids too, which matters to Fresnel's reflection.
    const bool has_inside =
        std::holds_alternative<Glass>(scattering) || std::holds_alternative<PovFinish>(scattering);
    if (has_inside && is_closed(shape.geometry) && may_hold_start(shapes, id, half)) {
      effects.call(Effect::camera_in_glass, shape.span);
    }
  }
  return effects;
}

Status check_built_in(const EffectSet& effects, std::string_view left_out) {
  for (std::size_t i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (!effects.has(effect) || !is_left_out(effect, left_out)) continue;
    return Error{ErrorCode::unsupported,
                 fmt::format("the scene calls for {}, which this build leaves out; `alhazen "
                             "explain` says where, and a build without {} in ALHAZEN_LEAVE_OUT "
                             "has it",
                             info(effect).text, info(effect).name)};
  }
  return Unit{};
}

}  // namespace alhazen::render
