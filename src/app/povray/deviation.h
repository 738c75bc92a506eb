// app/povray: what POV-Ray cannot say exactly, and what is said instead.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/diag/source.h"

namespace alhazen {

enum class DeviationKind {
#define ALHAZEN_DEVIATION(name, said, nearest, difference) name,
#include "app/povray/deviation.def"
#undef ALHAZEN_DEVIATION
};

struct DeviationInfo {
  std::string_view name, said, nearest, difference;
};
const DeviationInfo& info(DeviationKind kind);

struct Deviation {
  DeviationKind kind;
  SourceSpan span;  // of the scene's line that says it
};

// "scene.scn:3:5: a thin lens is exported as ...; expect a difference in ...", one line each.
std::string deviation_text(const Deviation& deviation, const SourceManager& sources);

}  // namespace alhazen
