// render/image: PNG out, for previews.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/base/result.h"

namespace alhazen::render {

// 8-bit RGB (`components` 3) or RGBA with alpha not premultiplied (4), interleaved, rows from the
// top; the file says that they are sRGB. The same pixels give the same bytes. Fails with
// ErrorCode::usage when the samples do not fill width * height pixels or there are none.
Result<std::string> encode_png(std::span<const std::uint8_t> samples, int width, int height,
                               int components);

// encode_png to a file that appears whole or not at all.
Status write_png(const std::filesystem::path& path, std::span<const std::uint8_t> samples,
                 int width, int height, int components);

}  // namespace alhazen::render
