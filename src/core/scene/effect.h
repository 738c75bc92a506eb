// core/scene: what a scene calls for, derived once. Only what can reach a pixel counts: a material
// that no shape wears, a light of zero intensity or an aperture of zero calls for nothing.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace alhazen {

enum class Effect {
#define ALHAZEN_EFFECT(name, text, cause) name,
#include "core/scene/effect.def"
#undef ALHAZEN_EFFECT
};

struct EffectInfo {
  std::string_view name, text, cause;
};
inline constexpr EffectInfo kEffectInfo[] = {
#define ALHAZEN_EFFECT(name, text, cause) {#name, text, cause},
#include "core/scene/effect.def"
#undef ALHAZEN_EFFECT
};
inline constexpr std::size_t kEffectCount = std::size(kEffectInfo);
constexpr const EffectInfo& info(Effect effect) {
  return kEffectInfo[static_cast<std::size_t>(effect)];
}

class EffectSet {
 public:
  bool has(Effect effect) const { return called_[index(effect)]; }
  // The lines of the scene that call for it, each once, in the scene's order; may be empty for an
  // effect that is on by default.
  const std::vector<SourceSpan>& callers(Effect effect) const { return callers_[index(effect)]; }
  void call(Effect effect, SourceSpan by);

 private:
  static std::size_t index(Effect effect) { return static_cast<std::size_t>(effect); }
  std::array<bool, kEffectCount> called_{};
  std::array<std::vector<SourceSpan>, kEffectCount> callers_;
};

// `albedo_channel`: the picture is wanted with the colours of surfaces that no light and no ray
// asks for.
EffectSet derive_effects(const Scene& scene, bool albedo_channel = false);

}  // namespace alhazen
