// parser/eval: real metals by name.
#pragma once

#include <optional>
#include <string_view>

#include "core/scene/material.h"

namespace alhazen::parser {

// The complex index of a metal of the schema's list, for the three channels.
std::optional<Metal> metal_preset(std::string_view name);

}  // namespace alhazen::parser
