#include "app/povray/deviation.h"

#include <fmt/format.h>
#include <map>

namespace alhazen {
namespace {

constexpr DeviationInfo kInfo[] = {
#define ALHAZEN_DEVIATION(name, said, nearest, difference) {#name, said, nearest, difference},
#include "app/povray/deviation.def"
#undef ALHAZEN_DEVIATION
};

constexpr std::size_t kListedLines = 6;

// " (a.scn:3:5, a.scn:9:1 and 4 more)", or "" for nowhere.
std::string places(const std::vector<SourceSpan>& spans, const SourceManager& sources) {
  std::string list;
  for (std::size_t i = 0; i < spans.size() && i < kListedLines; ++i)
    list += (list.empty() ? "" : ", ") + sources.describe(spans[i]);
  if (list.empty()) return "";
  if (spans.size() > kListedLines) list += fmt::format(" and {} more", spans.size() - kListedLines);
  return " (" + list + ")";
}

}  // namespace

const DeviationInfo& info(DeviationKind kind) {
  return kInfo[static_cast<std::size_t>(kind)];
}

std::vector<std::string> deviation_texts(std::span<const Deviation> deviations,
                                         const SourceManager& sources) {
  std::vector<DeviationKind> kinds;
  std::map<DeviationKind, std::vector<SourceSpan>> lines;
  for (const Deviation& deviation : deviations) {
    std::vector<SourceSpan>& of_kind = lines[deviation.kind];
    if (of_kind.empty()) kinds.push_back(deviation.kind);
    of_kind.push_back(deviation.span);
  }
  std::vector<std::string> texts;
  for (const DeviationKind kind : kinds) {
    const DeviationInfo& about = info(kind);
    texts.push_back(fmt::format("{}: POV-Ray gets {}. What differs: {}.{}", about.said,
                                about.nearest, about.difference, places(lines[kind], sources)));
  }
  return texts;
}

}  // namespace alhazen
