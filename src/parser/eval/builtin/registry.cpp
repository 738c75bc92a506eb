// parser/eval: every built-in name.
#include <algorithm>
#include <unordered_map>

#include "core/base/same_name.h"
#include "parser/eval/builtin/builtin.h"

namespace alhazen::parser {

Value BuiltinCall::outside_domain(std::size_t i, std::string_view rule) const {
  context.report<DiagnosticKind::argument_outside_domain>(spans[i], function, rule,
                                                          to_text(values[i], 60));
  return Poison{};
}

std::span<const BuiltinSection> builtin_sections() {
  static const BuiltinSection sections[] = {
      {"Numbers", math_functions()},     {"Angles", angle_functions()},
      {"Vectors", vector_functions()},   {"Lists and strings", list_functions()},
      {"Chance", random_functions()},    {"Colours", color_functions()},
      {"Textures", texture_functions()},
  };
  return sections;
}

std::span<const BuiltinConstant> builtin_constants() {
  static const BuiltinConstant constants[] = {
      {"x", Vec3d{1, 0, 0}, "to the right"},
      {"y", Vec3d{0, 1, 0}, "up"},
      {"z", Vec3d{0, 0, 1}, "into the picture"},
      {"pi", alhazen::pi<double>(), "the number 3.141592653589793; angles do not need it"},
  };
  return constants;
}

const BuiltinFunction* find_builtin(std::string_view name) {
  static const auto by_name = [] {
    std::unordered_map<std::string_view, const BuiltinFunction*> map;
    for (const BuiltinSection& section : builtin_sections()) {
      for (const BuiltinFunction& function : section.functions)
        map.emplace(function.name, &function);
    }
    return map;
  }();
  const auto it = by_name.find(name);
  return it == by_name.end() ? nullptr : it->second;
}

const BuiltinConstant* find_constant(std::string_view name) {
  const auto constants = builtin_constants();
  const auto it = std::find_if(constants.begin(), constants.end(),
                               [&](const BuiltinConstant& c) { return same_name(c.name, name); });
  return it == constants.end() ? nullptr : &*it;
}

std::vector<std::string_view> builtin_names() {
  std::vector<std::string_view> names;
  for (const BuiltinSection& section : builtin_sections()) {
    for (const BuiltinFunction& function : section.functions)
      names.push_back(function.name);
  }
  for (const BuiltinConstant& constant : builtin_constants())
    names.push_back(constant.name);
  return names;
}

std::string signature(const BuiltinFunction& function) {
  std::string out(function.name);
  out += '(';
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const BuiltinParameter& parameter = function.parameters[i];
    if (parameter.optional) out += '[';
    if (i > 0) out += ", ";
    out += parameter.name;
    if (function.variadic && i + 1 == function.parameters.size()) out += ", ...";
    if (parameter.optional) out += ']';
  }
  return out + ')';
}

}  // namespace alhazen::parser
