// app/study: one way to make the picture: which knob is turned, and the settings that come of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "render/wave/render.h"

namespace alhazen {

enum class Knob {
#define ALHAZEN_KNOB(name, title, text) name,
#include "app/study/knob.def"
#undef ALHAZEN_KNOB
};

struct KnobInfo {
  std::string_view name, title, text;
};
inline constexpr KnobInfo kKnobInfo[] = {
#define ALHAZEN_KNOB(name, title, text) {#name, title, text},
#include "app/study/knob.def"
#undef ALHAZEN_KNOB
};
inline constexpr std::size_t kKnobCount = std::size(kKnobInfo);
constexpr const KnobInfo& info(Knob knob) {
  return kKnobInfo[static_cast<std::size_t>(knob)];
}

struct StudySetting {
  Knob knob = Knob::samples;
  std::string label;  // beside its point: "16"
  RenderSettings settings;
  std::optional<int> light_samples;  // of every area light; empty: as the scene says
  render::Precision precision = render::Precision::float64;
  int rank = 0;           // of those that the budget takes first; 0 is the first
  bool is_scene = false;  // exactly what the scene says
};

// Whether a picture of both is the same.
bool is_same(const StudySetting& a, const StudySetting& b);

// What makes the picture of `setting`.
Scene scene_with(const Scene& scene, const StudySetting& setting);

// "16 samples, depth 4, cutoff 1/512, box": everything that could have been chosen otherwise. The
// number of light samples is told when it is not the scene's.
std::string describe(const StudySetting& setting);

// The samples, and of everything else what is not as in `own`: "16 samples, depth 4".
std::string describe_beside(const StudySetting& setting, const StudySetting& own);

std::string_view setting_name(render::Precision precision);
std::string_view setting_name(FilterKind kind);
// "1/512" where that is what it is, otherwise the number; of cutoffs and of error targets.
std::string cutoff_text(double cutoff);

}  // namespace alhazen
