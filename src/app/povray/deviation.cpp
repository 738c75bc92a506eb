#include "app/povray/deviation.h"

#include <fmt/format.h>

namespace alhazen {
namespace {

constexpr DeviationInfo kInfo[] = {
#define ALHAZEN_DEVIATION(name, said, nearest, difference) {#name, said, nearest, difference},
#include "app/povray/deviation.def"
#undef ALHAZEN_DEVIATION
};

}  // namespace

const DeviationInfo& info(DeviationKind kind) {
  return kInfo[static_cast<std::size_t>(kind)];
}

std::string deviation_text(const Deviation& deviation, const SourceManager& sources) {
  const DeviationInfo& about = info(deviation.kind);
  const std::string place = sources.describe(deviation.span);
  return fmt::format("{}{}{} is exported as {}; what differs: {}", place, place.empty() ? "" : ": ",
                     about.said, about.nearest, about.difference);
}

}  // namespace alhazen
