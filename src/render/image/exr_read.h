// render/image: any flat EXR file as planes of floats.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "render/image/exr_file.h"
#include "render/image/image_limits.h"
#include "render/image/pixel_buffer.h"

namespace alhazen::render {

struct ExrPart {
  std::string name;  // empty in most files of one part
  PixelWindow display_window;
  PixelWindow data_window;
  // All channels in the order of the file, which is alphabetical. half and float samples are exact;
  // a 32-bit integer above 2^24 is rounded. NaN and infinities are left as they are.
  FloatBuffer pixels;
  std::vector<SampleType> types;                  // of the channels, as stored
  std::map<std::string, std::string> attributes;  // every attribute as text
};

bool is_exr(std::string_view bytes);

// Scanline and tiled parts (full resolution only). Errors: ErrorCode::io for what is not an EXR
// file, truncated, damaged, or without pixels; ErrorCode::unsupported for deep parts and subsampled
// channels; ErrorCode::limit.
Result<std::vector<ExrPart>> decode_exr(std::string_view bytes, const ImageLimits& limits = {});

// decode_exr of a file; messages name it.
Result<std::vector<ExrPart>> read_exr(const std::filesystem::path& path,
                                      const ImageLimits& limits = {});

}  // namespace alhazen::render
