// render/image: a picture file as planes of colour, whatever its format. No colour decisions here:
// what the numbers mean is for render/color to say.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"
#include "render/image/image_limits.h"
#include "render/image/pixel_buffer.h"

namespace alhazen::render {

enum class ImageFormat { png, jpeg, exr };

struct ReadImage {
  ImageFormat format{};
  // R, G, B, and A when the file has it; gray is repeated in the three. PNG and JPEG give the
  // encoded value divided by its maximum, exactly rounded; EXR what it holds, of its data window,
  // which is what texture coordinates of an EXR texture refer to.
  FloatBuffer pixels;
};

// Tells the format by the first bytes, never by the name. Errors: ErrorCode::io for a file that is
// none of the formats, truncated or damaged, or an EXR without R, G, B (or Y);
// ErrorCode::unsupported for CMYK JPEG and for kinds of EXR that exr_read.h lists;
// ErrorCode::limit.
Result<ReadImage> decode_image(std::string_view bytes, const ImageLimits& limits = {});

// decode_image of a file; messages name it.
Result<ReadImage> read_image(const std::filesystem::path& path, const ImageLimits& limits = {});

}  // namespace alhazen::render
