#include <fmt/format.h>

#include "core/scene/this_build.h"
#include "render/wave/camera_solids.h"
#include "render/wave/plan.h"

namespace alhazen::render {
EffectSet effects_of(const Scene& scene, const PlanWants& wants) {
  EffectSet effects = derive_effects(scene, wants.albedo);
  if (!effects.has(Effect::refraction) && !effects.has(Effect::pov_transmission)) return effects;
  const WorldShapes<double> shapes(scene.shapes, scene.camera.frame.position);
  const Vec3d half = reach_of_starts(scene);
  // In POV-Ray one is inside of opaque solids too, which matters to Fresnel's reflection.
  for (const ShapeId solid : clear_solids(scene, shapes)) {
    if (may_hold_start(shapes, solid, half)) {
      effects.call(Effect::camera_in_glass, scene.shapes[solid].span);
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

Status check_built_in(const EffectSet& effects) {
  return check_built_in(effects, kLeftOutNames);
}

}  // namespace alhazen::render
