// app/nff: pieces of a scene's text, in the layout of `alhazen fmt`.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/vec.h"

namespace alhazen {

// `<x, y, z>` of a vector that NFF writes as x, z, y.
std::string scn_vector(Vec3d nff);
std::string scn_color(Rgbd color);  // `rgb(0.5)` if its parts are equal

// Appends a block with its line break: `head { property  property }` if that fits into a line of
// 100 columns, otherwise one property a line, two columns further in.
void append_block(std::string& out, int indentation, std::string_view head,
                  const std::vector<std::string>& properties);

// `name [a, b, c]`, or one element a line if it does not fit into a line of a block that is
// indented by `indentation`. Such a property breaks its block.
std::string scn_list(std::string_view name, const std::vector<std::string>& elements,
                     int indentation);

}  // namespace alhazen
