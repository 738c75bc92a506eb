#include "app/povray/povray_picture.h"

#include <algorithm>
#include <fmt/format.h>

#include "render/image/exr_read.h"

namespace alhazen {

Result<render::FloatBuffer> read_povray_picture(const std::filesystem::path& path, int width,
                                                int height) {
  const auto parts = render::read_exr(path);
  if (!parts) return parts.error();
  const render::FloatBuffer& pixels = parts.value().front().pixels;
  if (pixels.width() != width || pixels.height() != height) {
    return Error{ErrorCode::io, fmt::format("POV-Ray's picture has {} x {} pixels, not {} x {}",
                                            pixels.width(), pixels.height(), width, height)};
  }
  render::FloatBuffer out(width, height, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c) {
    const auto channel = pixels.find(out.names()[c]);
    if (!channel) {
      return Error{ErrorCode::io,
                   fmt::format("POV-Ray's picture has no channel {}", out.names()[c])};
    }
    std::ranges::copy(pixels.channel(*channel), out.channel(c).begin());
  }
  return out;
}

}  // namespace alhazen
