// render/color: the library that converts colours.
#pragma once

#include <vector>

#include "core/base/library_version.h"

namespace alhazen::render {

std::vector<LibraryVersion> color_library_versions();

}  // namespace alhazen::render
