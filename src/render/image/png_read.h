// render/image: PNG in.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "render/image/image_limits.h"
#include "render/image/pixel_buffer.h"

namespace alhazen::render {

bool is_png(std::string_view bytes);

// Every PNG there is: 1 to 16 bits, gray, palette, colour, alpha, interlaced. Gamma and colour
// chunks are ignored: see image_read.h for what comes out and for the errors.
Result<FloatBuffer> decode_png(std::string_view bytes, const ImageLimits& limits);

}  // namespace alhazen::render
