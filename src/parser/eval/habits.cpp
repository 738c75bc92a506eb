#include "parser/eval/habits.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <vector>

#include "parser/eval/metal_presets.h"
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {
namespace {

struct Habit {
  std::string_view word, hint;
};
constexpr std::string_view kGroup = "several things as one are a `group { ... }`";
constexpr std::string_view kNoDifference =
    "there are no differences; for glass in glass see `priority`";
constexpr std::string_view kSurroundings =
    "write `background gradient { ... }` or `background environment { ... }`";
constexpr Habit kItems[] = {
    {"light_source", "write `light point { position <5, 8, -5>  intensity rgb(60) }`"},
    {"union", kGroup},
    {"merge", kGroup},
    {"difference", kNoDifference},
    {"intersection", kNoDifference},
    {"cube", "write `box { min <-1, 0, -1>  max <1, 2, 1> }`"},
    {"ellipsoid", "write `sphere { scale <1, 2, 1> }`"},
    {"smooth_triangle", "write `triangle { ... }` with `normals`"},
    {"mesh", "write `group { ... }` with each `triangle { ... }` in it"},
    {"sky_sphere", kSurroundings},
    {"global_settings", "write `render { ... }`"},
};
// Shapes elsewhere, and nothing here that would take their place.
constexpr std::string_view kOtherShapes[] = {
    "torus",      "blob",  "prism",   "lathe",         "sor",         "superellipsoid",
    "text",       "mesh2", "quadric", "height_field",  "isosurface",  "bicubic_patch",
    "parametric", "ovus",  "polygon", "julia_fractal", "sphere_sweep"};
constexpr std::string_view kOfMaterials[] = {"pigment", "texture", "color", "colour", "finish"};
// Of the web and of POV-Ray's colors.inc, in lower case.
constexpr std::string_view kColors[] = {"red",    "green",  "blue", "white",   "black",
                                        "yellow", "orange", "cyan", "magenta", "purple",
                                        "pink",   "brown",  "gray", "grey",    "violet"};

template <class Words>
bool holds(const Words& words, std::string_view word) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

}  // namespace

std::string foreign_item_hint(std::string_view word) {
  for (const Habit& habit : kItems) {
    if (habit.word == word) return std::string(habit.hint);
  }
  if (!holds(kOtherShapes, word)) return "";
  std::vector<std::string_view> shapes;
  for (const BlockSchema* shape : shape_schemas())
    shapes.push_back(shape->name);
  return fmt::format("the shapes are `{}`", fmt::join(shapes, "`, `"));
}

std::string foreign_material_hint(std::string_view word) {
  if (!holds(kOfMaterials, word)) return "";
  return "colours belong to a material: `material diffuse { color rgb(0.8) }`";
}

std::string foreign_value_hint(std::string_view name) {
  if (metal_preset(name)) return fmt::format("write `material metal {{ preset {} }}`", name);
  std::string lower(name);
  for (char& c : lower)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return holds(kColors, lower) ? "colours have no names: `rgb(1, 0, 0)` or `#f00`" : "";
}

}  // namespace alhazen::parser
