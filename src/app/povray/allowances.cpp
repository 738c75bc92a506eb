#include "app/povray/allowances.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace alhazen {
namespace {

using Json = nlohmann::json;

Error wrong(std::string_view name, const std::string& what) {
  return {ErrorCode::usage, fmt::format("{}: {}", name, what)};
}

// Parses, and notices a key that comes twice in one object, of which JSON would keep the last.
class KeyCheck {
 public:
  Json parse(std::string_view text) {
    return Json::parse(
        text,
        [this](int, Json::parse_event_t event, Json& value) {
          if (event == Json::parse_event_t::object_start) keys_.emplace_back();
          if (event == Json::parse_event_t::object_end) keys_.pop_back();
          if (event == Json::parse_event_t::key &&
              !keys_.back().insert(value.get<std::string>()).second) {
            twice_ = value.get<std::string>();
          }
          return true;
        },
        false);
  }
  const std::optional<std::string>& twice() const { return twice_; }

 private:
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
  std::optional<std::string> twice_;
};

}  // namespace

Result<Allowances> parse_allowances(std::string_view text, std::string_view name) {
  KeyCheck keys;
  const Json all = keys.parse(text);
  if (!all.is_object()) return wrong(name, "expected a JSON object of scenes");
  if (keys.twice()) return wrong(name, fmt::format("`{}` is there twice", *keys.twice()));
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
