#include "render/color/color_transform.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "render/color/ocio.h"

namespace alhazen::render {

ColorTransform::ColorTransform(std::shared_ptr<const Processor> processor)
    : processor_(std::move(processor)) {}

void ColorTransform::apply(const RgbPlanes& pixels) const {
  // Packed rows of four channels are the one layout that OpenColorIO converts without a copy of its
  // own; always the same layout also means always the same code, and so the same bits.
  constexpr std::size_t kMostPixels = 4096;
  std::vector<float> packed(4 * std::min(kMostPixels, pixels.red.size()));
  for (std::size_t begin = 0; begin < pixels.red.size(); begin += kMostPixels) {
    const std::size_t count = std::min(kMostPixels, pixels.red.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      packed[4 * i] = pixels.red[begin + i];
      packed[4 * i + 1] = pixels.green[begin + i];
      packed[4 * i + 2] = pixels.blue[begin + i];
      packed[4 * i + 3] = 1;
    }
    ocio::PackedImageDesc image(packed.data(), static_cast<long>(count), 1, 4);
    processor_->cpu->apply(image);
    for (std::size_t i = 0; i < count; ++i) {
      pixels.red[begin + i] = packed[4 * i];
      pixels.green[begin + i] = packed[4 * i + 1];
      pixels.blue[begin + i] = packed[4 * i + 2];
    }
  }
}

}  // namespace alhazen::render
