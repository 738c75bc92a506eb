// core/scene: builds without some effects. -DALHAZEN_LEAVE_OUT="mirror;textures" names them: then
// their stages are not compiled, and a scene that calls for one is refused. bench/effects measures
// with such builds what an effect costs where it is not used: nothing. Here is what follows from
// such a list; this_build.h has the list itself.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/scene/effect.h"

namespace alhazen {

// Whether `name` is a word of `list`, whose words stand between commas.
constexpr bool lists(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
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
    const std::size_t end = std::min(list.find(','), list.size());
    if (!is_name_of_effect(list.substr(0, end))) return false;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return true;
}

// A scene that calls for the part always calls for the whole.
struct EffectPart {
  Effect part, whole;
};
inline constexpr EffectPart kEffectParts[] = {
#define ALHAZEN_EFFECT_PART(part, whole) {Effect::part, Effect::whole},
#include "core/scene/effect_part.def"
#undef ALHAZEN_EFFECT_PART
};

// `list` as ALHAZEN_LEAVE_OUT, with commas.
constexpr bool is_left_out(Effect effect, std::string_view list) {
  if (lists(list, info(effect).name)) return true;
  return std::any_of(std::begin(kEffectParts), std::end(kEffectParts), [&](const EffectPart& p) {
    return p.part == effect && is_left_out(p.whole, list);
  });
}

}  // namespace alhazen
