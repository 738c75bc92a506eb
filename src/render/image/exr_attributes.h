// render/image: EXR attributes as text, for people and for tests.
#pragma once

#include <OpenEXR/ImfHeader.h>
#include <map>
#include <string>

namespace alhazen::render {

// Numbers are written so that they read back to the same value; components are separated by spaces,
// matrices row by row as stored. An attribute of another type gives its type in angle brackets.
std::map<std::string, std::string> attribute_texts(const Imf::Header& header);

}  // namespace alhazen::render
