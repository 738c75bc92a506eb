#include "core/scene/effect.h"

#include <algorithm>
#include <initializer_list>

#include "core/base/overloaded.h"

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
  std::vector<std::optional<Rgbd>> solid;
  std::vector<bool> visited;
  EffectSet& set;
};

void call_texture(Walk& walk, TextureId id) {
  if (walk.solid[id] || walk.visited[id]) return;
  walk.visited[id] = true;
  const Texture& texture = walk.scene.textures[id];
  walk.set.call(Effect::textures, texture.span);
  std::visit(
      Overloaded{[](const SolidPattern&) {}, [](const GradientPattern&) {},
                 [&](const ImagePattern&) { walk.set.call(Effect::image_textures, texture.span); },
                 [&](const BrickPattern& p) {
                   call_texture(walk, p.brick);
                   call_texture(walk, p.mortar);
                 },
                 [&](const auto& p) {
                   call_texture(walk, p.even);
                   call_texture(walk, p.odd);
                 }},
      texture.pattern);
}

void call_pov_finish(Walk& walk, const PovFinish& m, SourceSpan by) {
  const bool is_black_body = walk.solid[m.color] && is_black(*walk.solid[m.color]);
  const bool colored = !is_black_body && opacity(m) > 0;
  const bool glows = !is_black(m.ambient) || !is_black(m.emission);
  const bool reflects = !is_black(m.reflection.min) || !is_black(m.reflection.max);
  EffectSet& set = walk.set;
  const auto call_if = [&](bool called, Effect effect) {
    if (called) set.call(effect, by);
    return called;
  };
  const bool shades =
      call_if((colored && m.diffuse > 0) || m.phong > 0 || m.specular > 0, Effect::pov_finish);
  const bool shows = call_if(colored && glows, Effect::pov_glow);
  const bool mirrors = call_if(reflects, Effect::pov_reflection);
  const bool passes = call_if(lets_light_through(m, walk.solid), Effect::pov_transmission);
  if (shades || shows || mirrors || passes) call_texture(walk, m.color);
}

void call_scattering(Walk& walk, const Material& material, SourceSpan by) {
  EffectSet& set = walk.set;
  const auto is_zero = [&](TextureId id) { return walk.solid[id] && is_black(*walk.solid[id]); };
  std::visit(Overloaded{[&](const Diffuse& m) {
                          if (!is_black(m.highlight.strength)) {
                            set.call(Effect::highlights, material.span);
                          } else if (is_zero(m.albedo)) {
                            return;
                          } else {
                            set.call(Effect::matte, material.span);
                          }
                          call_texture(walk, m.albedo);
                        },
                        [&](const Mirror& m) {
                          if (is_zero(m.reflectance)) return;
                          set.call(Effect::mirror, material.span);
                          call_texture(walk, m.reflectance);
                        },
                        [&](const Metal&) { set.call(Effect::metal, material.span); },
                        [&](const Glass& m) {
                          set.call(Effect::refraction, material.span);
                          if (!is_black(m.absorption)) set.call(Effect::absorption, material.span);
                        },
                        [&](const Coat& m) {
                          set.call(Effect::coat, material.span);
                          if (is_zero(m.base_albedo)) return;
                          set.call(Effect::coat_base, material.span);
                          call_texture(walk, m.base_albedo);
                        },
                        [](const Black&) {},
                        [&](const PovFinish& m) { call_pov_finish(walk, m, material.span); }},
             material.scattering);
  if (!is_black(material.emission)) set.call(Effect::emission, by);
}

bool has_any(const EffectSet& set, std::initializer_list<Effect> effects) {
  return std::any_of(effects.begin(), effects.end(), [&](Effect e) { return set.has(e); });
}

void call_lights(const Scene& scene, EffectSet& set) {
  // Mirrors, metals and glass show lights as things; only these surfaces answer to them.
  if (!has_any(set, {Effect::matte, Effect::highlights, Effect::coat_base, Effect::pov_finish}))
    return;
  for (const Light& light : scene.lights) {
    if (!shines(light)) continue;
    set.call(effect_of(light.source), light.span);
    if (std::holds_alternative<AmbientLight>(light.source)) continue;
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
  if (scene.settings.samples > 1) set.call(Effect::antialiasing, scene.settings.span);
  if (scene.settings.adaptive) set.call(Effect::adaptive_sampling, scene.settings.span);
}

}  // namespace

void EffectSet::call(Effect effect, SourceSpan by) {
  called_[index(effect)] = true;
  auto& callers = callers_[index(effect)];
  if (by.known() && std::find(callers.begin(), callers.end(), by) == callers.end()) {
    callers.push_back(by);
  }
}

bool shines(const Light& light) {
  return std::visit(
      Overloaded{[](const PointLight& l) { return !is_black(l.intensity); },
                 [](const DirectionalLight& l) { return !is_black(l.irradiance); },
                 [](const SpotLight& l) { return !is_black(l.intensity) && l.outer_angle_deg > 0; },
                 [](const auto& area) { return !is_black(area.radiance); }},
      light.source);
}

std::vector<std::optional<Rgbd>> solid_colors(const Scene& scene) {
  std::vector<std::optional<Rgbd>> solid;
  const auto same = [&](TextureId a, TextureId b) -> std::optional<Rgbd> {
    return solid[a] && solid[b] && *solid[a] == *solid[b] ? solid[a] : std::nullopt;
  };
  for (const Texture& texture : scene.textures) {
    solid.push_back(std::visit(
        Overloaded{[](const SolidPattern& p) { return std::optional(p.color); },
                   [](const GradientPattern& p) -> std::optional<Rgbd> {
                     const Rgbd first = p.stops.front().color;
                     const bool equal =
                         std::all_of(p.stops.begin(), p.stops.end(),
                                     [&](const GradientStop& s) { return s.color == first; });
                     return equal ? std::optional(first) : std::nullopt;
                   },
                   [](const ImagePattern&) -> std::optional<Rgbd> { return std::nullopt; },
                   [&](const BrickPattern& p) { return same(p.brick, p.mortar); },
                   [&](const auto& p) { return same(p.even, p.odd); }},
        texture.pattern));
  }
  return solid;
}

bool lets_light_through(const PovFinish& finish, const std::vector<std::optional<Rgbd>>& solid) {
  const std::optional<Rgbd>& color = solid[finish.color];
  return finish.transmit > 0 || (finish.filter > 0 && !(color && is_black(*color)));
}

EffectSet derive_effects(const Scene& scene) {
  EffectSet set;
  Walk walk{scene, solid_colors(scene), std::vector<bool>(scene.textures.size()), set};
  std::vector<bool> seen(scene.materials.size());
  for (const Shape& shape : scene.shapes) {
    if (const auto* triangle = std::get_if<Triangle>(&shape.geometry)) {
      if (triangle->normals) set.call(Effect::smooth_normals, shape.span);
    }
    if (seen[shape.material]) continue;
    seen[shape.material] = true;
    call_scattering(walk, scene.materials[shape.material], shape.span);
  }
  call_lights(scene, set);
  call_background(scene, set);
  call_sampling(scene, set);
  return set;
}

}  // namespace alhazen
