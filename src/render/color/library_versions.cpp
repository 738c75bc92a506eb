#include "render/color/library_versions.h"

#include "render/color/ocio.h"

namespace alhazen::render {

std::vector<LibraryVersion> color_library_versions() {
  return {{"OpenColorIO", OCIO_VERSION_FULL_STR, ocio::GetVersion()}};
}

}  // namespace alhazen::render
