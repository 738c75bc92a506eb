// render/image: the samples of one part of an EXR file, compressed as they stand in it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/image/exr_output.h"

namespace alhazen::render {

struct ExrPlane {
  ExrChannel channel;
  std::span<const float> samples;  // of the data window, row after row
};

// In every row of a chunk the channels stand one after the other, sorted by their names; half
// floats are rounded to nearest, ties to even. Each chunk has `chunk_rows` rows of `width` samples
// a channel, a divisor of 64; the last may have less. Up to `threads` threads share the work.
std::vector<std::string> compressed_chunks(std::vector<ExrPlane> planes, int width, int chunk_rows,
                                           int threads);

}  // namespace alhazen::render
