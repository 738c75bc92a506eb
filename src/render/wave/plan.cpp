#include "render/wave/plan.h"

#include <algorithm>
#include <iterator>

namespace alhazen::render {
namespace {

class Planner {
 public:
  Planner(const Scene& scene, const EffectSet& effects, const PlanWants& wants)
      : scene_(scene), effects_(effects), wants_(wants) {}

  StagePlan plan() {
    add_camera();
    if (!scene_.shapes.empty()) {
      if (effects_.has(Effect::refraction)) {
        when(StageId::interfaces, {Effect::refraction});
      } else if (effects_.has(Effect::pov_transmission)) {
        when(StageId::interfaces, {Effect::pov_transmission});
      } else {
        always(StageId::closest_hits);
      }
      when(StageId::absorb, {Effect::absorption});
    }
    when(StageId::escape, {Effect::background});
    if (!scene_.shapes.empty()) add_surfaces();
    return std::move(plan_);
  }

 private:
  void add_camera() {
    if (std::holds_alternative<OrthographicCamera>(scene_.camera.projection)) {
      always(StageId::parallel_rays);
    } else if (effects_.has(Effect::depth_of_field)) {
      when(StageId::lens_rays, {Effect::depth_of_field});
    } else {
      always(StageId::pinhole_rays);
    }
    when(StageId::camera_media, {Effect::camera_in_glass});
  }

  void add_surfaces() {
    const bool lit = effects_.has(Effect::direct_light) || effects_.has(Effect::ambient_light);
    const bool scattering = effects_.has(Effect::matte) || effects_.has(Effect::highlights) ||
                            effects_.has(Effect::coat_base) || effects_.has(Effect::pov_finish);
    const bool pov_colored = effects_.has(Effect::pov_glow) ||
                             effects_.has(Effect::pov_reflection) ||
                             effects_.has(Effect::pov_transmission);
    const bool colored =
        (lit && scattering) || effects_.has(Effect::mirror) || pov_colored || wants_.albedo;
    const bool reflecting = effects_.has(Effect::mirror) || effects_.has(Effect::metal) ||
                            effects_.has(Effect::coat) || effects_.has(Effect::refraction);
    if (colored && effects_.has(Effect::textures)) {
      when(StageId::textured_surfaces, {Effect::textures});
      when(StageId::textured_colors, {Effect::textures});
    } else {
      if (colored || reflecting) always(StageId::surfaces);
      if (colored) always(StageId::plain_colors);
    }
    add_decisions(effects_.has(Effect::direct_light) && scattering);
    when(StageId::emission, {Effect::emission});
    when(StageId::pov_glow, {Effect::pov_glow});
    add_lights();
    when(StageId::mirror, {Effect::mirror});
    when(StageId::metal, {Effect::metal});
    when(StageId::coat, {Effect::coat});
    when(StageId::glass, {Effect::refraction});
    when(StageId::pov_reflection, {Effect::pov_reflection});
    when(StageId::pov_transmission, {Effect::pov_transmission});
  }

  void add_decisions(bool shone_upon) {
    if (wants_.signature) {
      always(StageId::sign_hits);
      if (shone_upon) when(StageId::sign_lights, {Effect::direct_light});
    }
    if (wants_.margin) {
      always(StageId::weigh_hits);
      if (shone_upon) when(StageId::weigh_lights, {Effect::direct_light});
    }
  }

  void add_lights() {
    constexpr StageId kFirstStage = StageId::ambient_on_matte;
    constexpr Effect kLights[] = {Effect::ambient_light,      Effect::point_lights,
                                  Effect::directional_lights, Effect::spot_lights,
                                  Effect::sphere_lights,      Effect::rectangle_lights};
    constexpr Effect kSurfaces[] = {Effect::matte, Effect::highlights, Effect::coat_base,
                                    Effect::pov_finish};
    static_assert(static_cast<int>(StageId::rectangle_on_pov) - static_cast<int>(kFirstStage) + 1 ==
                      std::size(kLights) * std::size(kSurfaces),
                  "stage.def lists each light on each surface in this order");
    int stage = static_cast<int>(kFirstStage);
    for (const Effect light : kLights) {
      for (const Effect surface : kSurfaces) {
        when(static_cast<StageId>(stage++), {light, surface});
      }
    }
    if (effects_.has(Effect::tinted_shadows)) {
      when(StageId::tinted_shadows, {Effect::shadows, Effect::tinted_shadows});
    } else {
      when(StageId::opaque_shadows, {Effect::shadows});
    }
    const bool unshadowed =
        std::any_of(scene_.lights.begin(), scene_.lights.end(), [](const Light& light) {
          return shines(light) && !light.casts_shadows &&
                 !std::holds_alternative<AmbientLight>(light.source);
        });
    if (unshadowed) when(StageId::unshadowed, {Effect::direct_light});
  }

  void always(StageId id) { add({id, {}}); }

  void when(StageId id, std::vector<Effect> effects) {
    const bool called = std::all_of(effects.begin(), effects.end(),
                                    [&](Effect effect) { return effects_.has(effect); });
    if (called) add({id, std::move(effects)});
  }

  void add(PlannedStage stage) {
    auto& phase = info(stage.id).phase == Phase::start ? plan_.start : plan_.generation;
    phase.push_back(std::move(stage));
  }

  const Scene& scene_;
  const EffectSet& effects_;
  const PlanWants& wants_;
  StagePlan plan_;
};

bool same_stages(const std::vector<PlannedStage>& a, const std::vector<PlannedStage>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const PlannedStage& x, const PlannedStage& y) { return x.id == y.id; });
}

}  // namespace

bool StagePlan::runs(StageId id) const {
  const auto& phase = info(id).phase == Phase::start ? start : generation;
  return std::any_of(phase.begin(), phase.end(),
                     [&](const PlannedStage& stage) { return stage.id == id; });
}

bool operator==(const StagePlan& a, const StagePlan& b) {
  return same_stages(a.start, b.start) && same_stages(a.generation, b.generation);
}

StagePlan make_plan(const Scene& scene, const EffectSet& effects, const PlanWants& wants) {
  return Planner(scene, effects, wants).plan();
}

}  // namespace alhazen::render
