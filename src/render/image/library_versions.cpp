#include "render/image/library_versions.h"

#include <OpenEXR/OpenEXRConfig.h>
#include <OpenEXR/openexr_base.h>
#include <cstdio>
#include <fmt/format.h>
#include <jpeglib.h>
#include <libdeflate.h>
#include <png.h>

namespace alhazen::render {

std::vector<LibraryVersion> image_library_versions() {
  int major = 0, minor = 0, patch = 0;
  const char* extra = nullptr;
  ::exr_get_library_version(&major, &minor, &patch, &extra);
  constexpr int jpeg = LIBJPEG_TURBO_VERSION_NUMBER;  // 2001005 is 2.1.5
  return {{"OpenEXR", OPENEXR_VERSION_STRING, fmt::format("{}.{}.{}", major, minor, patch)},
          {"libdeflate", LIBDEFLATE_VERSION_STRING, ""},
          {"libpng", PNG_LIBPNG_VER_STRING, ::png_get_libpng_ver(nullptr)},
          {"libjpeg-turbo",
           fmt::format("{}.{}.{}", jpeg / 1000000, jpeg / 1000 % 1000, jpeg % 1000), ""}};
}

}  // namespace alhazen::render
