// parser/eval: what each kind of block takes, as tables. They drive the checks, the defaults, the
// suggestions and the reference manual, so that none of these can disagree.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "parser/eval/value.h"

namespace alhazen::parser {

struct BlockSchema;

// Of a number, of each component of a vector and each channel of a colour; of angles in degrees.
struct NumberRange {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_open = false, max_open = false;  // the bound itself is outside
  bool integer = false;
  bool nonzero = false;  // for vectors: not all components
  constexpr bool contains(double value) const {
    return (min_open ? value > min : value >= min) && (max_open ? value < max : value <= max);
  }
  friend constexpr bool operator==(const NumberRange&, const NumberRange&) = default;
};
constexpr NumberRange at_least(double min) {
  return {.min = min};
}
constexpr NumberRange above(double min) {
  return {.min = min, .min_open = true};
}
constexpr NumberRange between(double min, double max) {
  return {.min = min, .max = max};
}
constexpr NumberRange strictly_between(double min, double max) {
  return {.min = min, .max = max, .min_open = true, .max_open = true};
}
constexpr NumberRange integers(double min, double max) {
  return {.min = min, .max = max, .integer = true};
}
inline constexpr NumberRange kNonzero = {.nonzero = true};

// The value of a property that is not written. Which kind it is follows from the property's types.
struct Default {
  enum class Kind { none, number, angle, boolean, vec2, vec3, color, word } kind = Kind::none;
  std::array<double, 3> v{};
  std::string_view word{};
};
constexpr Default number_default(double x) {
  return {Default::Kind::number, {x, 0, 0}, {}};
}
constexpr Default angle_default(double deg) {
  return {Default::Kind::angle, {deg, 0, 0}, {}};
}
constexpr Default bool_default(bool b) {
  return {Default::Kind::boolean, {b ? 1. : 0., 0, 0}, {}};
}
constexpr Default vec2_default(double x, double y) {
  return {Default::Kind::vec2, {x, y, 0}, {}};
}
constexpr Default vec3_default(double x, double y, double z) {
  return {Default::Kind::vec3, {x, y, z}, {}};
}
constexpr Default gray_default(double c) {
  return {Default::Kind::color, {c, c, c}, {}};
}
constexpr Default word_default(std::string_view w) {
  return {Default::Kind::word, {}, w};
}

enum class Presence { optional, required, repeatable };

using Words = std::span<const std::string_view>;

struct PropertySpec {
  std::string_view name;
  TypeSet types = 0;  // of an expression as its value; 0: takes words or blocks only
  Presence presence = Presence::optional;
  NumberRange range{};
  Default default_value{};
  Words words{};                                 // bare words it takes: `filter gaussian`
  std::span<const BlockSchema* const> blocks{};  // kinds of blocks it takes: `light point { ... }`
  bool kind_named = true;                        // false: one kind, unnamed: `lens { ... }`
  std::string_view doc{};
};

struct BlockSchema {
  std::string_view name{};
  std::string_view doc{};
  std::array<std::span<const PropertySpec>, 3> tables{};
  bool places = false;  // shapes, groups, objects and lights may stand in it
  std::string_view
      example{};  // a line that can stand in a scene, or in a shape for what belongs to one

  const PropertySpec* find(std::string_view property) const;
  std::vector<std::string_view> property_names() const;
};

// Shared tables (schema/common.cpp).
extern const std::array<PropertySpec, 4> kTransformProperties;
extern const std::array<PropertySpec, 2> kPlacedProperties;  // material, name
extern const BlockSchema kPovFinish;  // the material of schema/pov_finish.cpp

// Every kind there is, by what it makes (one file each in schema/).
std::span<const BlockSchema* const> shape_schemas();      // `sphere { ... }`
std::span<const BlockSchema* const> material_schemas();   // `diffuse { ... }`
std::span<const BlockSchema* const> highlight_schemas();  // `phong { ... }`
std::span<const BlockSchema* const> light_schemas();      // `light point { ... }`
std::span<const BlockSchema* const> texture_schemas();    // bodies of textures, by pattern
std::span<const BlockSchema* const> camera_schemas();
std::span<const BlockSchema* const> background_schemas();
std::span<const BlockSchema* const> render_schemas();
const BlockSchema& group_schema();
const BlockSchema& object_schema();
const BlockSchema& scene_schema();

const BlockSchema* find_schema(std::span<const BlockSchema* const> kinds, std::string_view name);

// "at least 0", "above 0 and below 180", "" for no bound.
std::string describe(const NumberRange& range);
std::string describe(const Default& value);

}  // namespace alhazen::parser
