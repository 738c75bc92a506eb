#include "app/compare/hdr_flip.h"

#include <algorithm>

namespace alhazen {
namespace {

// `largest` and the mean of `errors`, whose other fields are not set yet.
void summarize(FlipResult& result) {
  double sum = 0.0;
  for (int y = 0; y < result.errors.height(); ++y) {
    for (int x = 0; x < result.errors.width(); ++x) {
      const double error = result.errors.at(0, x, y);
      sum += error;
      if (error > result.largest.error) result.largest = {error, {x, y}};
    }
  }
  result.mean = sum / static_cast<double>(result.errors.pixel_count());
}

}  // namespace

HdrFlipResult hdr_flip(const render::FloatBuffer& a, const render::FloatBuffer& b,
                       double pixels_per_degree) {
  HdrFlipResult result{{render::FloatBuffer(a.width(), a.height(), {"FLIP.E"}), 0.0, {}},
                       flip_exposures(b)};
  const std::span<float> errors = result.flip.errors.channel(0);
  for (int i = 0; i < result.exposures.count; ++i) {
    const double exposure = result.exposures.at(i);
    const FlipResult once =
        flip(tone_mapped(a, exposure), tone_mapped(b, exposure), pixels_per_degree);
    const std::span<const float> more = once.errors.channel(0);
    for (std::size_t pixel = 0; pixel < errors.size(); ++pixel)
      errors[pixel] = std::max(errors[pixel], more[pixel]);
  }
  summarize(result.flip);
  return result;
}

}  // namespace alhazen
