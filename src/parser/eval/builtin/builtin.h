// parser/eval: the functions and constants of the language, as tables: the checks of their
// arguments and the reference manual come from the same rows.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/base/small_vector.h"
#include "parser/eval/context.h"
#include "parser/eval/value.h"

namespace alhazen::parser {

// The checked arguments of one call of a built-in function.
struct BuiltinCall {
  Context& context;
  SourceSpan span;               // of the call
  SmallVector<Value, 6> values;  // one for each parameter, poison where it was left out
  SmallVector<SourceSpan, 6> spans;

  bool has(std::size_t i) const { return i < values.size() && !values[i].is_poison(); }
  double number(std::size_t i) const { return values[i].number(); }
  double number_or(std::size_t i, double otherwise) const { return has(i) ? number(i) : otherwise; }
  double deg(std::size_t i) const { return values[i].as<Angle>().deg; }
  Vec3d vec3(std::size_t i) const { return values[i].as<Vec3d>(); }
  Rgbd color(std::size_t i) const { return values[i].as<Rgbd>(); }

  // Reports that argument i is outside of what the function is defined for: "`sqrt` needs ...".
  // Returns poison.
  Value outside_domain(std::size_t i, std::string_view rule) const;
  std::string_view function;
};

struct BuiltinParameter {
  std::string_view name;
  TypeSet types = kAnyType;
  bool optional = false;
};

struct BuiltinFunction {
  std::string_view name;
  std::span<const BuiltinParameter> parameters;
  bool variadic = false;  // the last parameter may be repeated
  std::string_view result;
  std::string_view doc;
  Value (*apply)(const BuiltinCall& call);
};

struct BuiltinConstant {
  std::string_view name;
  Value value;
  std::string_view doc;
};

std::span<const BuiltinFunction> math_functions();
std::span<const BuiltinFunction> angle_functions();
std::span<const BuiltinFunction> vector_functions();
std::span<const BuiltinFunction> list_functions();
std::span<const BuiltinFunction> random_functions();
std::span<const BuiltinFunction> color_functions();
std::span<const BuiltinFunction> texture_functions();

struct BuiltinSection {
  std::string_view title;
  std::span<const BuiltinFunction> functions;
};
std::span<const BuiltinSection> builtin_sections();
std::span<const BuiltinConstant> builtin_constants();

const BuiltinFunction* find_builtin(std::string_view name);
const BuiltinConstant* find_constant(std::string_view name);
std::vector<std::string_view> builtin_names();

// "clamp(value, low, high)", optional parameters in brackets.
std::string signature(const BuiltinFunction& function);

}  // namespace alhazen::parser
