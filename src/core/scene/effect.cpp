#include "core/scene/effect.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "core/base/overloaded.h"
#include "core/scene/live.h"

namespace alhazen {
namespace {

Effect effect_of(const LightSource& source) {
  static constexpr Effect kEffects[] = {Effect::point_lights,     Effect::directional_lights,
                                        Effect::spot_lights,      Effect::sphere_lights,
                                        Effect::rectangle_lights, Effect::ambient_light};
  return kEffects[source.index()];
}

bool is_area(const LightSource& source) {
  return std::holds_alternative<SphereLight>(source) ||
         std::holds_alternative<RectangleLight>(source);
}

// What the walk over materials carries along: textures share children, so each is visited once.
struct Walk {
  const Scene& scene;
  const Surroundings around;
  const bool albedo_channel;
  EffectSet& set;
  std::vector<bool> visited = std::vector<bool>(scene.textures.size());
  bool answers_evenly = false;  // some surface would be lit by an even sky
};

void call_texture(Walk& walk, TextureId id) {
  if (walk.around.solid[id] || walk.visited[id]) return;
  walk.visited[id] = true;
  const Texture& texture = walk.scene.textures[id];
  walk.set.call(Effect::textures, texture.span);
  std::visit(
      Overloaded{[](const SolidPattern&) {}, [](const GradientPattern&) {},
                 [&](const ImagePattern&) { walk.set.call(Effect::image_textures, texture.span); },
                 [&](const BrickPattern& p) {
                   call_texture(walk, p.brick);
                   if (p.mortar_width > 0) call_texture(walk, p.mortar);
                 },
                 [&](const auto& p) {
                   call_texture(walk, p.even);
                   call_texture(walk, p.odd);
                 }},
      texture.pattern);
}

// What each material does with a ray or with light, and whether its normal matters to it.
class Caller {
 public:
  Caller(Walk& walk, SourceSpan by) : walk_(walk), around_(walk.around), by_(by) {}

  bool operator()(const Diffuse& m) {
    const bool has_color = shows_color(m.albedo, around_);
    walk_.answers_evenly = walk_.answers_evenly || has_color;
    const bool glossy = call_if(shows_highlight(m, around_), Effect::highlights);
    const bool matte = !glossy && call_if(has_color, Effect::matte);
    color(m.albedo, has_color);
    return glossy || matte;
  }
  bool operator()(const Mirror& m) {
    const bool mirrors = call_if(!is_black(around_.solid, m.reflectance), Effect::mirror);
    color(m.reflectance, mirrors);
    return mirrors;
  }
  bool operator()(const Metal& m) { return call_if(reflects(m, around_), Effect::metal); }
  bool operator()(const Glass& m) {
    call_if(!is_black(m.absorption), Effect::absorption);
    return call_if(true, Effect::refraction);
  }
  bool operator()(const Coat& m) {
    const bool has_base = call_if(shows_color(m.base_albedo, around_), Effect::coat_base);
    walk_.answers_evenly = walk_.answers_evenly || has_base;
    color(m.base_albedo, has_base);
    return call_if(true, Effect::coat);
  }
  bool operator()(const Black&) { return false; }
  bool operator()(const PovFinish& m) {
    walk_.answers_evenly = walk_.answers_evenly || shows_diffuse(m, around_);
    const bool shades = call_if(answers_to_lights(m, around_), Effect::pov_finish);
    const bool shows = call_if(glows(m, around_.solid), Effect::pov_glow);
    const bool mirrors = call_if(reflects(m, around_), Effect::pov_reflection);
    const bool passes = call_if(lets_light_through(m, around_.solid), Effect::pov_transmission);
    color(m.color, shades || shows || mirrors || passes);
    return shades || mirrors || passes;
  }

 private:
  bool call_if(bool called, Effect effect) {
    if (called) walk_.set.call(effect, by_);
    return called;
  }
  void color(TextureId texture, bool is_seen) {
    if (is_seen || walk_.albedo_channel) call_texture(walk_, texture);
  }

  Walk& walk_;
  const Surroundings& around_;
  SourceSpan by_;
};

void call_surfaces(Walk& walk) {
  enum class Answer : std::uint8_t { unknown, with_normal, without };
  std::vector<Answer> answers(walk.scene.materials.size(), Answer::unknown);
  walk.scene.shapes.for_each_different([&](const Shape& shape, ShapeId) {
    Answer& answer = answers[shape.material];
    if (answer == Answer::unknown) {
      const Material& material = walk.scene.materials[shape.material];
      const bool is_shaded = std::visit(Caller(walk, material.span), material.scattering);
      answer = is_shaded ? Answer::with_normal : Answer::without;
      if (!is_black(material.emission)) walk.set.call(Effect::emission, shape.span);
    }
    const auto* triangle = std::get_if<Triangle>(&shape.geometry);
    if (triangle && triangle->normals && answer == Answer::with_normal) {
      walk.set.call(Effect::smooth_normals, shape.span);
    }
  });
}

bool has_any(const EffectSet& set, std::initializer_list<Effect> effects) {
  return std::any_of(effects.begin(), effects.end(), [&](Effect e) { return set.has(e); });
}

void call_lights(const Scene& scene, bool answers_evenly, EffectSet& set) {
  // Mirrors, metals and glass show lights as things; only these surfaces answer to them.
  if (!has_any(set, {Effect::matte, Effect::highlights, Effect::coat_base, Effect::pov_finish}))
    return;
  for (const Light& light : scene.lights) {
    if (!shines(light)) continue;
    const bool is_placed = !std::holds_alternative<AmbientLight>(light.source);
    if (is_placed || answers_evenly) set.call(effect_of(light.source), light.span);
    if (!is_placed) continue;
    set.call(Effect::direct_light, light.span);
    if (!light.casts_shadows) continue;
    set.call(Effect::shadows, light.span);
    if (is_area(light.source)) set.call(Effect::soft_shadows, light.span);
    for (const Effect clear : {Effect::refraction, Effect::pov_transmission}) {
      if (!set.has(clear)) continue;
      set.call(Effect::tinted_shadows, {});
      for (const SourceSpan solid : set.callers(clear))
        set.call(Effect::tinted_shadows, solid);
    }
  }
}

void call_background(const Scene& scene, EffectSet& set) {
  const Background& background = scene.background;
  const bool lit = std::visit(
      Overloaded{[](const SolidBackground& b) { return !is_black(b.color); },
                 [](const GradientBackground& b) {
                   return std::any_of(b.stops.begin(), b.stops.end(),
                                      [](const GradientStop& s) { return !is_black(s.color); });
                 },
                 [](const EnvironmentBackground& b) { return b.intensity != 0; }},
      background.source);
  // Behind a transparent picture only rays that were reflected or refracted see the background.
  const bool seen = !scene.settings.transparent_background ||
                    has_any(set, {Effect::mirror, Effect::metal, Effect::coat, Effect::refraction,
                                  Effect::pov_reflection, Effect::pov_transmission});
  if (!lit || !seen) return;
  set.call(Effect::background, background.span);
  if (std::holds_alternative<EnvironmentBackground>(background.source)) {
    set.call(Effect::environment_image, background.span);
  }
}

void call_sampling(const Scene& scene, EffectSet& set) {
  const auto* perspective = std::get_if<PerspectiveCamera>(&scene.camera.projection);
  if (perspective && perspective->lens && perspective->lens->aperture_radius > 0) {
    set.call(Effect::depth_of_field, scene.camera.span);
  }
  const RenderSettings& settings = scene.settings;
  const bool to_target = settings.max_error.has_value();
  if (settings.samples > 1 || to_target) set.call(Effect::antialiasing, settings.span);
  if (to_target || (settings.adaptive && settings.adaptive->min_samples < settings.samples)) {
    set.call(Effect::adaptive_sampling, settings.span);
  }
}

}  // namespace

void EffectSet::call(Effect effect, SourceSpan by) {
  called_[index(effect)] = true;
  auto& callers = callers_[index(effect)];
  if (by.known() && std::find(callers.begin(), callers.end(), by) == callers.end()) {
    callers.push_back(by);
  }
}

EffectSet derive_effects(const Scene& scene, bool albedo_channel) {
  EffectSet set;
  Walk walk{scene, surroundings_of(scene), albedo_channel, set};
  call_surfaces(walk);
  call_lights(scene, walk.answers_evenly, set);
  call_background(scene, set);
  call_sampling(scene, set);
  return set;
}

}  // namespace alhazen
