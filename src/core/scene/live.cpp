#include "core/scene/live.h"

#include <algorithm>

#include "core/base/overloaded.h"

namespace alhazen {
namespace {

// A mortar of no width is nowhere.
std::optional<Rgbd> solid_color(const Pattern& pattern, const SolidColors& earlier) {
  const auto same = [&](TextureId a, TextureId b) -> std::optional<Rgbd> {
    return earlier[a] && earlier[b] && *earlier[a] == *earlier[b] ? earlier[a] : std::nullopt;
  };
  return std::visit(
      Overloaded{[](const SolidPattern& p) { return std::optional(p.color); },
                 [](const GradientPattern& p) {
                   return is_one_color(p.stops) ? std::optional(p.stops.front().color)
                                                : std::nullopt;
                 },
                 [](const ImagePattern&) -> std::optional<Rgbd> { return std::nullopt; },
                 [&](const BrickPattern& p) {
                   return p.mortar_width == 0 ? earlier[p.brick] : same(p.brick, p.mortar);
                 },
                 [&](const auto& p) { return same(p.even, p.odd); }},
      pattern);
}

bool has_index(const Scattering& scattering) {
  const auto* glass = std::get_if<Glass>(&scattering);
  const auto* finish = std::get_if<PovFinish>(&scattering);
  return (glass && glass->ior != 1) || (finish && finish->ior != 1);
}

}  // namespace

bool shines(const Light& light) {
  return std::visit(
      Overloaded{[](const PointLight& l) { return !is_black(l.intensity); },
                 [](const DirectionalLight& l) { return !is_black(l.irradiance); },
                 [](const SpotLight& l) { return !is_black(l.intensity) && l.outer_angle_deg > 0; },
                 [](const auto& area) { return !is_black(area.radiance); }},
      light.source);
}

ShiningLights shining_lights(const Scene& scene) {
  ShiningLights lights;
  for (const Light& light : scene.lights) {
    if (!shines(light)) continue;
    const bool placed = !std::holds_alternative<AmbientLight>(light.source);
    lights.any = true;
    lights.placed = lights.placed || placed;
    lights.shadowing = lights.shadowing || (placed && light.casts_shadows);
  }
  return lights;
}

SolidColors solid_colors(const Scene& scene) {
  SolidColors solid;
  for (const Texture& texture : scene.textures)
    solid.push_back(solid_color(texture.pattern, solid));
  return solid;
}

bool is_black(const SolidColors& solid, TextureId texture) {
  return solid[texture] && is_black(*solid[texture]);
}

Surroundings surroundings_of(const Scene& scene) {
  bool bends = false;
  const bool may_bend =
      std::any_of(scene.materials.begin(), scene.materials.end(),
                  [](const Material& material) { return has_index(material.scattering); });
  if (may_bend) {
    scene.shapes.for_each_different([&](const Shape& shape, ShapeId) {
      bends = bends || has_index(scene.materials[shape.material].scattering);
    });
  }
  return {solid_colors(scene), shining_lights(scene), bends};
}

bool shows_highlight(const Diffuse& diffuse, const Surroundings& around) {
  return around.lights.placed && !is_black(diffuse.highlight.strength);
}

bool shows_color(TextureId color, const Surroundings& around) {
  return around.lights.any && !is_black(around.solid, color);
}

bool reflects(const Metal& metal, const Surroundings& around) {
  const bool is_as_vacuum = metal.n == Rgbd(1) && is_black(metal.k);
  return around.bends_light || !is_as_vacuum;
}

bool reflects(const PovFinish& finish, const Surroundings& around) {
  const PovReflection& reflection = finish.reflection;
  if (!is_black(reflection.min)) return true;
  // Fresnel's reflectance is that of no interface at all.
  const bool is_none = reflection.fresnel && finish.ior == 1 && !around.bends_light;
  return !is_black(reflection.max) && !is_none;
}

bool shows_diffuse(const PovFinish& finish, const Surroundings& around) {
  return opacity(finish) > 0 && finish.diffuse > 0 && shows_color(finish.color, around);
}

bool answers_to_lights(const PovFinish& finish, const Surroundings& around) {
  const bool has_highlight = finish.phong > 0 || finish.specular > 0;
  return shows_diffuse(finish, around) || (around.lights.shadowing && has_highlight);
}

bool glows(const PovFinish& finish, const SolidColors& solid) {
  const bool has_light = !is_black(finish.ambient) || !is_black(finish.emission);
  return has_light && opacity(finish) > 0 && !is_black(solid, finish.color);
}

bool lets_light_through(const PovFinish& finish, const SolidColors& solid) {
  return finish.transmit > 0 || (finish.filter > 0 && !is_black(solid, finish.color));
}

}  // namespace alhazen
