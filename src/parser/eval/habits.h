// parser/eval: words that people bring along from other renderers, and what to write here.
#pragma once

#include <string>
#include <string_view>

namespace alhazen::parser {

// Hints, each "" if there is none.

// For an unknown word where shapes may stand: `light_source`, `union`, `torus`.
std::string foreign_item_hint(std::string_view word);

// For an unknown word in something that has a material: `pigment`, `color`.
std::string foreign_material_hint(std::string_view word);

// For an unknown name as a value: `red`, `gold`.
std::string foreign_value_hint(std::string_view name);

}  // namespace alhazen::parser
