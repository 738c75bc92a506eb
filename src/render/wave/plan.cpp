#include "render/wave/plan.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "core/scene/live.h"

namespace alhazen::render {
namespace {

class Planner {
 public:
  Planner(const Scene& scene, const EffectSet& effects, const PlanWants& wants)
      : scene_(scene), effects_(effects), wants_(wants) {}

  StagePlan plan() {
    add_camera();
    if (!scene_.shapes.empty()) {
      first_of(StageId::interfaces, StageId::closest_hits);
      when(StageId::absorb);
    }
    first_of(StageId::environment, StageId::escape);
    if (!scene_.shapes.empty()) add_surfaces();
    when(StageId::adaptive_rounds);
    return std::move(plan_);
  }

 private:
  void add_camera() {
    when(StageId::spread_samples);
    if (std::holds_alternative<OrthographicCamera>(scene_.camera.projection)) {
      when(StageId::parallel_rays);
    } else {
      first_of(StageId::lens_rays, StageId::pinhole_rays);
    }
    when(StageId::camera_media);
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
      when(StageId::textured_surfaces, {Effect::smooth_normals});
      when(StageId::textured_colors, {Effect::image_textures});
    } else {
      if (colored || reflecting) when(StageId::surfaces, {Effect::smooth_normals});
      if (colored) when(StageId::plain_colors);
    }
    add_decisions(effects_.has(Effect::direct_light) && scattering);
    when(StageId::emission);
    when(StageId::pov_glow);
    add_lights();
    when(StageId::mirror);
    when(StageId::metal);
    when(StageId::coat);
    when(StageId::glass);
    when(StageId::pov_reflection);
    when(StageId::pov_transmission);
  }

  void add_decisions(bool shone_upon) {
    if (wants_.signature) {
      when(StageId::sign_hits);
      if (shone_upon) when(StageId::sign_lights);
    }
    if (wants_.margin) {
      when(StageId::weigh_hits);
      if (shone_upon) when(StageId::weigh_lights);
    }
  }

  void add_lights() {
    for (auto id = StageId::ambient_on_matte; id <= StageId::ambient_on_pov; id = after(id))
      when(id);
    for (auto id = StageId::point_on_matte; id <= StageId::rectangle_on_pov; id = after(id))
      when(id, {Effect::direct_light});
    const StageId shadows =
        effects_.has(Effect::tinted_shadows) ? StageId::tinted_shadows : StageId::opaque_shadows;
    when(shadows, {Effect::soft_shadows});
    const bool unshadowed =
        std::any_of(scene_.lights.begin(), scene_.lights.end(), [](const Light& light) {
          return shines(light) && !light.casts_shadows &&
                 !std::holds_alternative<AmbientLight>(light.source);
        });
    if (unshadowed) when(StageId::unshadowed);
  }

  static StageId after(StageId id) { return static_cast<StageId>(static_cast<int>(id) + 1); }

  auto called() const {
    return [this](Effect effect) { return effects_.has(effect); };
  }

  // Plans the stage if it is called for. `served`: effects that have some of their work done in it.
  void when(StageId id, std::initializer_list<Effect> served = {}) {
    if (!is_called(id, called())) return;
    PlannedStage stage{id, reasons(id), {}};
    std::copy_if(served.begin(), served.end(), std::back_inserter(stage.serves), called());
    std::vector<PlannedStage>* const phases[] = {&plan_.start, &plan_.generation, &plan_.round};
    phases[static_cast<std::size_t>(info(id).phase)]->push_back(std::move(stage));
  }

  // The one if it is called for, else the other.
  void first_of(StageId one, StageId other) { when(is_called(one, called()) ? one : other); }

  // The effects called for without which the stage would not be, or which alone are enough for it.
  std::vector<Effect> reasons(StageId id) const {
    std::vector<Effect> because;
    if (is_called(id, [](Effect) { return false; })) return because;
    for (std::size_t i = 0; i < kEffectCount; ++i) {
      const auto effect = static_cast<Effect>(i);
      if (!effects_.has(effect)) continue;
      const auto others = [&](Effect e) { return e != effect && effects_.has(e); };
      const auto alone = [&](Effect e) { return e == effect; };
      if (!is_called(id, others) || is_called(id, alone)) because.push_back(effect);
    }
    return because;
  }

  const Scene& scene_;
  const EffectSet& effects_;
  const PlanWants& wants_;
  StagePlan plan_;
};

}  // namespace

bool StagePlan::runs(StageId id) const {
  bool found = false;
  for_each([&](const PlannedStage& stage) { found = found || stage.id == id; });
  return found;
}

StagePlan make_plan(const Scene& scene, const EffectSet& effects, const PlanWants& wants) {
  return Planner(scene, effects, wants).plan();
}

}  // namespace alhazen::render
