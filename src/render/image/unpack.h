// render/image: interleaved integer samples, as PNG and JPEG decoders give them, to float planes.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "render/image/pixel_buffer.h"

namespace alhazen::render {

// R, G, B (and A for four components) in 0 .. 1: each sample divided by the largest of its type.
// Preconditions: `components` is 3 or 4; the samples fill width * height pixels.
template <class Sample>
FloatBuffer unpack(std::span<const Sample> samples, int width, int height, int components) {
  std::vector<std::string> names{"R", "G", "B"};
  if (components == 4) names.emplace_back("A");
  FloatBuffer buffer(width, height, std::move(names));
  const std::size_t stride = buffer.channel_count();
  constexpr auto kLargest = static_cast<float>(std::numeric_limits<Sample>::max());
  for (std::size_t c = 0; c < stride; ++c) {
    const std::span<float> plane = buffer.channel(c);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      plane[i] = static_cast<float>(samples[i * stride + c]) / kLargest;
    }
  }
  return buffer;
}

}  // namespace alhazen::render
