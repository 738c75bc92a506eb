// app/compare: a picture file of any kind, to be compared.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/compare/display_values.h"
#include "core/base/result.h"
#include "render/image/exr_read.h"

namespace alhazen {

struct ComparedPicture {
  std::string name;  // for texts: the file
  PixelEncoding encoding = PixelEncoding::light;
  std::vector<render::ExrPart> parts;  // of a PNG or JPEG one, with R, G, B and perhaps A
};

// Tells the kind by the first bytes. Messages of errors name the file; ErrorCode::io for what
// cannot be read or is no picture, and as exr_read.h and image_read.h say.
Result<ComparedPicture> read_picture(const std::filesystem::path& path);

}  // namespace alhazen
