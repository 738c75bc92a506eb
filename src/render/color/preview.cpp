#include "render/color/preview.h"

#include <array>

namespace alhazen::render {
namespace {

std::uint8_t byte(float value) {
  if (!(value > 0)) return 0;
  if (value >= 1) return 255;
  // In double the product is exact, so halves are halves: 0.5 + 127.5 steps go up.
  return static_cast<std::uint8_t>(static_cast<double>(value) * 255.0 + 0.5);
}

}  // namespace

std::vector<std::uint8_t> preview_rgb8(const ColorTransform& view, std::span<const float> red,
                                       std::span<const float> green, std::span<const float> blue) {
  const std::array<std::span<const float>, 3> channels{red, green, blue};
  std::array<std::vector<float>, 3> planes;
  for (std::size_t c = 0; c < 3; ++c)
    planes[c].assign(channels[c].begin(), channels[c].end());
  view.apply({planes[0], planes[1], planes[2]});
  std::vector<std::uint8_t> bytes(3 * red.size());
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = byte(planes[i % 3][i / 3]);
  return bytes;
}

}  // namespace alhazen::render
