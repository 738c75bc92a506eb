// app/povray: what POV-Ray cannot say exactly, and what is said instead.
#pragma once

#include <span>
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

// One text a kind, in the order in which the kinds come first: what the scene says, what POV-Ray
// gets instead, what differs, and the lines that say it, of which only the first few are listed.
std::vector<std::string> deviation_texts(std::span<const Deviation> deviations,
                                         const SourceManager& sources);

}  // namespace alhazen
