// render/image: JPEG in.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "render/image/image_limits.h"
#include "render/image/pixel_buffer.h"

namespace alhazen::render {

bool is_jpeg(std::string_view bytes);

// Baseline and progressive JPEG, gray or colour. A file whose pixels are damaged is an error even
// where a viewer would show half a picture. See image_read.h for what comes out and for the errors.
Result<FloatBuffer> decode_jpeg(std::string_view bytes, const ImageLimits& limits);

}  // namespace alhazen::render
