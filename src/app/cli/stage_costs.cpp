#include "app/cli/stage_costs.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/cli/quantity_text.h"

namespace alhazen {
namespace {

using Json = nlohmann::json;

const render::StageInfo* find_stage(const std::string& name) {
  const auto* found = std::find_if(std::begin(render::kStageInfo), std::end(render::kStageInfo),
                                   [&](const render::StageInfo& s) { return s.name == name; });
  return found == std::end(render::kStageInfo) ? nullptr : found;
}

Error not_statistics(const std::string& name, const std::string& reason) {
  return {ErrorCode::io, fmt::format("{} is not what `alhazen render --stats` of this version "
                                     "writes: {}",
                                     name, reason)};
}

bool has_figures(const Json& stage) {
  return stage.is_object() && stage.contains("name") && stage["name"].is_string() &&
         stage.contains("rays") && stage["rays"].is_number_unsigned() &&
         stage.contains("cpu_seconds") && stage["cpu_seconds"].is_number();
}

Status add_picture(const std::string& name, const Json& picture, StageCosts& costs) {
  const bool is_picture = picture.is_object() && picture.contains("stages") &&
                          picture["stages"].is_array() &&
                          picture.value("/seconds/render_cpu"_json_pointer, Json()).is_number();
  if (!is_picture) return not_statistics(name, "it has no `stages`, or no `seconds.render_cpu`");
  costs.cpu_seconds += picture["seconds"]["render_cpu"].get<double>();
  for (const Json& stage : picture["stages"]) {
    if (!has_figures(stage)) {
      return not_statistics(name, "a stage lacks its `name`, `rays` or `cpu_seconds`");
    }
    const render::StageInfo* known = find_stage(stage["name"].get<std::string>());
    if (known == nullptr) {
      return not_statistics(
          name, fmt::format("there is no stage `{}`", stage["name"].get<std::string>()));
    }
    const auto id = static_cast<render::StageId>(known - std::begin(render::kStageInfo));
    auto place = std::find_if(costs.stages.begin(), costs.stages.end(),
                              [&](const render::StageCost& cost) { return cost.stage >= id; });
    if (place == costs.stages.end() || place->stage != id) {
      place = costs.stages.insert(place, {id, 0, 0});
    }
    place->rays += stage["rays"].get<std::uint64_t>();
    place->cpu_seconds += stage["cpu_seconds"].get<double>();
  }
  return Unit{};
}

std::string row(const std::string& items, double seconds, double whole, const std::string& each) {
  const std::string share = whole > 0 ? fmt::format("{:.1f} %", 100 * seconds / whole) : "";
  return fmt::format("{:>10}{:>12}{:>9}{:>11}", items, seconds_text(seconds), share, each);
}

}  // namespace

const render::StageCost* StageCosts::of(render::StageId stage) const {
  const auto found = std::find_if(stages.begin(), stages.end(),
                                  [&](const render::StageCost& c) { return c.stage == stage; });
  return found == stages.end() ? nullptr : &*found;
}

Result<StageCosts> read_stage_costs(const std::string& name, const std::string& json) {
  const Json whole = Json::parse(json, nullptr, false);
  if (whole.is_discarded()) return not_statistics(name, "it is not JSON");
  StageCosts costs;
  const Json pictures = whole.is_array() ? whole : Json::array({whole});
  for (const Json& picture : pictures) {
    const Status added = add_picture(name, picture, costs);
    if (!added) return added.error();
  }
  return costs;
}

std::string stage_cost_heading() {
  return fmt::format("{:>10}{:>12}{:>9}{:>11}", "rays", "CPU time", "share", "ns a ray");
}

std::string stage_cost_row(const render::StageCost& cost, double cpu_seconds) {
  const auto count = static_cast<double>(cost.rays);
  const std::string each =
      cost.rays > 0 ? fmt::format("{:.1f}", 1e9 * cost.cpu_seconds / count) : "";
  return row(count_text(count), cost.cpu_seconds, cpu_seconds, each);
}

std::string other_cost_row(const StageCosts& costs) {
  double rest = costs.cpu_seconds;
  for (const render::StageCost& cost : costs.stages)
    rest -= cost.cpu_seconds;
  return row("", std::max(rest, 0.0), costs.cpu_seconds, "");
}

}  // namespace alhazen
