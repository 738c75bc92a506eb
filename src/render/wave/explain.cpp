#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

#include "render/wave/plan.h"

namespace alhazen::render {
namespace {

constexpr std::size_t kMaxShownLines = 4;

std::string lines_of(const std::vector<SourceSpan>& spans, const SourceManager& sources) {
  std::string out;
  for (std::size_t i = 0; i < spans.size() && i < kMaxShownLines; ++i) {
    out += (i == 0 ? "" : ", ") + sources.describe(spans[i]);
  }
  if (spans.size() > kMaxShownLines) {
    out += fmt::format(" and {} more", spans.size() - kMaxShownLines);
  }
  return out;
}

std::string reasons(const PlannedStage& stage) {
  std::string out;
  for (const Effect effect : stage.because) {
    out += (out.empty() ? "" : " and ") +
           std::string(kEffectInfo[static_cast<std::size_t>(effect)].text);
  }
  return out.empty() ? "every picture needs it" : out;
}

}  // namespace

std::string explain_text(const StagePlan& plan, const EffectSet& effects,
                         const SourceManager& sources) {
  std::string out = "Effects\n";
  const auto put = [&]<class... Args>(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
  };
  for (std::size_t i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    const EffectInfo& about = kEffectInfo[i];
    if (effects.has(effect)) {
      const std::string lines = lines_of(effects.callers(effect), sources);
      put("  yes  {:<22}{}\n", about.text, lines.empty() ? "(settings)" : lines);
    } else {
      put("  -    {:<22}nothing calls for it: {}\n", about.text, about.cause);
    }
  }
  const auto put_stages = [&](std::string_view title, const std::vector<PlannedStage>& stages) {
    put("{}\n", title);
    for (const PlannedStage& stage : stages) {
      put("  {:<60} because: {}\n", info(stage.id).text, reasons(stage));
      if (!info(stage.id).keeps.empty()) put("    keeps: {}\n", info(stage.id).keeps);
    }
  };
  put_stages("\nStages for each batch of camera samples", plan.start);
  put_stages("\nStages for each generation of rays", plan.generation);
  return out;
}

std::string explain_json(const StagePlan& plan, const EffectSet& effects,
                         const SourceManager& sources) {
  nlohmann::ordered_json out = {{"effects", nlohmann::ordered_json::array()},
                                {"stages", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const SourceSpan span : effects.callers(effect))
      lines.push_back(sources.describe(span));
    out["effects"].push_back({{"name", kEffectInfo[i].name},
                              {"text", kEffectInfo[i].text},
                              {"called", effects.has(effect)},
                              {"lines", std::move(lines)}});
  }
  plan.for_each([&](const PlannedStage& stage) {
    nlohmann::ordered_json because = nlohmann::ordered_json::array();
    for (const Effect effect : stage.because)
      because.push_back(info(effect).name);
    out["stages"].push_back(
        {{"name", info(stage.id).name},
         {"text", info(stage.id).text},
         {"phase", info(stage.id).phase == Phase::start ? "start" : "generation"},
         {"because", std::move(because)},
         {"keeps", info(stage.id).keeps}});
  });
  return out.dump(2) + "\n";
}

}  // namespace alhazen::render
