// render/image: an ExrFile as the bytes of an OpenEXR file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "render/image/exr_file.h"

namespace alhazen::render {

// Samples that could not be written as they were. Both counts also stand in the file, as
// alhazen/nanCount and alhazen/clampedCount.
struct ExrReport {
  std::uint64_t non_finite{};  // NaN or infinite: written as 0
  std::uint64_t clamped{};     // beyond +-65504 in a half channel: written as +-65504
};

struct EncodedExr {
  std::string bytes;
  ExrReport report;
};

// The same description gives the same bytes (with the same libdeflate), whatever the number of
// `threads` (at least 1) that compress them. Fails with ErrorCode::usage when the description
// contradicts itself (buffer sizes, channel names), with ErrorCode::io when OpenEXR refuses.
Result<EncodedExr> encode_exr(const ExrFile& file, int threads = 1);

// encode_exr to a file that appears whole or not at all.
Result<ExrReport> write_exr(const std::filesystem::path& path, const ExrFile& file);

}  // namespace alhazen::render
