// parser/eval: finding properties and describing ranges and defaults in words.
#include "parser/eval/schema/schema.h"

#include <fmt/format.h>

#include "core/base/same_name.h"

namespace alhazen::parser {

const PropertySpec* BlockSchema::find(std::string_view property) const {
  for (const auto& table : tables) {
    for (const PropertySpec& spec : table) {
      if (same_name(spec.name, property)) return &spec;
    }
  }
  return nullptr;
}

std::vector<std::string_view> BlockSchema::property_names() const {
  std::vector<std::string_view> names;
  for (const auto& table : tables) {
    for (const PropertySpec& spec : table)
      names.push_back(spec.name);
  }
  return names;
}

const BlockSchema* find_schema(std::span<const BlockSchema* const> kinds, std::string_view name) {
  for (const BlockSchema* kind : kinds) {
    if (same_name(kind->name, name)) return kind;
  }
  return nullptr;
}

std::string describe(const NumberRange& range) {
  const bool has_min = alhazen::is_finite(range.min), has_max = alhazen::is_finite(range.max);
  std::string out = range.integer ? "a whole number" : "";
  const auto add = [&](std::string_view part) {
    if (!out.empty()) out += ' ';
    out += part;
  };
  if (has_min && has_max && !range.min_open && !range.max_open) {
    add(fmt::format("from {} to {}", number_text(range.min), number_text(range.max)));
  } else {
    if (has_min) add((range.min_open ? "above " : "at least ") + number_text(range.min));
    if (has_min && has_max) add("and");
    if (has_max) add((range.max_open ? "below " : "at most ") + number_text(range.max));
  }
  if (range.nonzero) add("not zero");
  return out;
}

std::string describe(const Default& value) {
  const auto n = [&](int i) { return number_text(value.v[static_cast<std::size_t>(i)]); };
  switch (value.kind) {
    case Default::Kind::none:
      return "";
    case Default::Kind::number:
      return n(0);
    case Default::Kind::angle:
      return n(0) + "deg";
    case Default::Kind::boolean:
      return value.v[0] != 0 ? "true" : "false";
    case Default::Kind::vec2:
      return fmt::format("<{}, {}>", n(0), n(1));
    case Default::Kind::vec3:
      return fmt::format("<{}, {}, {}>", n(0), n(1), n(2));
    case Default::Kind::color:
      return fmt::format("rgb({})", n(0));
    case Default::Kind::word:
      return std::string(value.word);
  }
  return "";
}

}  // namespace alhazen::parser
