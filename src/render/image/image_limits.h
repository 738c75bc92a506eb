// render/image: how much a picture file may ask for. A scene is untrusted input, and a file of a
// hundred bytes can announce a picture of a terabyte.
#pragma once

#include <cstdint>

#include "core/base/result.h"

namespace alhazen::render {

struct ImageLimits {
  std::uint64_t max_pixels = 1ULL << 26;      // 8192 x 8192, of one part
  std::uint64_t max_samples = 1ULL << 29;     // pixels times channels, all parts: 2 GiB of float
  std::uint64_t max_file_bytes = 1ULL << 31;  // 2 GiB
};

// Nothing when width * height pixels of `channels` channels keep the limits, otherwise an error
// with ErrorCode::limit. Preconditions: width and height are positive and below 2^31.
inline Status within_limits(std::uint64_t width, std::uint64_t height, std::uint64_t channels,
                            const ImageLimits& limits) {
  const std::uint64_t pixels = width * height;
  if (pixels > limits.max_pixels || channels > limits.max_samples / pixels) {
    return Error{ErrorCode::limit,
                 "picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels and " + std::to_string(channels) + " channels is over the limit of " +
                     std::to_string(limits.max_pixels) + " pixels or " +
                     std::to_string(limits.max_samples) + " samples"};
  }
  return Unit{};
}

}  // namespace alhazen::render
