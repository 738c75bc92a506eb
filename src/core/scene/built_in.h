// core/scene: which effects this build has. All of them, unless
// -DALHAZEN_LEAVE_OUT="mirror;textures" names some: then their stages are not compiled, and a scene
// that calls for one is refused. bench/effects measures with such builds what an effect costs where
// it is not used: nothing.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/scene/effect.h"
#include "core/scene/left_out_names.h"

namespace alhazen {

// Whether `name` is a word of `list`, whose words stand between semicolons.
constexpr bool lists(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(';'), list.size());
    if (list.substr(0, end) == name) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

constexpr bool is_name_of_effect(std::string_view word) {
  return std::any_of(std::begin(kEffectInfo), std::end(kEffectInfo),
                     [&](const EffectInfo& effect) { return effect.name == word; });
}

constexpr bool lists_effects_only(std::string_view list) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(';'), list.size());
    if (!is_name_of_effect(list.substr(0, end))) return false;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return true;
}
static_assert(lists_effects_only(kLeftOutNames),
              "ALHAZEN_LEAVE_OUT names something that core/scene/effect.def does not");

// A scene that calls for the one always calls for the other.
struct PartOf {
  Effect part, whole;
};
inline constexpr PartOf kPartsOf[] = {{Effect::point_lights, Effect::direct_light},
                                      {Effect::directional_lights, Effect::direct_light},
                                      {Effect::spot_lights, Effect::direct_light},
                                      {Effect::sphere_lights, Effect::direct_light},
                                      {Effect::rectangle_lights, Effect::direct_light},
                                      {Effect::shadows, Effect::direct_light},
                                      {Effect::soft_shadows, Effect::shadows},
                                      {Effect::tinted_shadows, Effect::shadows},
                                      {Effect::coat_base, Effect::coat},
                                      {Effect::absorption, Effect::refraction},
                                      {Effect::image_textures, Effect::textures},
                                      {Effect::environment_image, Effect::background}};

// `list` as ALHAZEN_LEAVE_OUT.
constexpr bool is_left_out(Effect effect, std::string_view list) {
  if (lists(list, info(effect).name)) return true;
  return std::any_of(std::begin(kPartsOf), std::end(kPartsOf), [&](const PartOf& p) {
    return p.part == effect && is_left_out(p.whole, list);
  });
}

constexpr bool is_built_in(Effect effect) {
  return !is_left_out(effect, kLeftOutNames);
}

}  // namespace alhazen
