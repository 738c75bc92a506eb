// render/image: a first look at the header of an EXR file.
#pragma once

#include <string_view>

namespace alhazen::render {

// Whether every attribute of every part lies inside the file. OpenEXR takes memory for an attribute
// by the size that the file claims before it finds that there are no such bytes: a file of 500
// bytes could so ask for two gigabytes. Precondition: is_exr(bytes).
bool attributes_fit(std::string_view bytes);

}  // namespace alhazen::render
