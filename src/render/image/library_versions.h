// render/image: the libraries that read and write picture files.
#pragma once

#include <vector>

#include "core/base/library_version.h"

namespace alhazen::render {

std::vector<LibraryVersion> image_library_versions();

}  // namespace alhazen::render
