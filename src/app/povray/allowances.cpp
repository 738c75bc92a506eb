#include "app/povray/allowances.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alhazen {
namespace {

using Json = nlohmann::json;

Error wrong(std::string_view file, const std::string& what) {
  return {ErrorCode::usage, fmt::format("{}: {}", file, what)};
}

}  // namespace

Result<Allowances> parse_allowances(std::string_view text, std::string_view name) {
  const Json all = Json::parse(text, nullptr, false);
  if (!all.is_object()) return wrong(name, "expected a JSON object of scenes");
  Allowances out;
  for (const auto& [scene, entry] : all.items()) {
    const bool complete = entry.is_object() && entry.size() == 2 && entry.contains("rmse") &&
                          entry.contains("reason") && entry["rmse"].is_number() &&
                          entry["reason"].is_string();
    if (!complete) {
      return wrong(name, fmt::format("`{}` needs exactly two things, a number `rmse` and a text "
                                     "`reason`",
                                     scene));
    }
    Allowance allowance{entry["rmse"].get<double>(), entry["reason"].get<std::string>()};
    if (!(allowance.rmse > 0)) {
      return wrong(name, fmt::format("`rmse` of `{}` is not above 0", scene));
    }
    if (allowance.reason.empty()) {
      return wrong(name, fmt::format("`reason` of `{}` is empty", scene));
    }
    out.emplace(scene, std::move(allowance));
  }
  return out;
}

}  // namespace alhazen
