// tests/unit/app/compare: small pictures to compare.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/compare/read_picture.h"

namespace alhazen {

// Every sample of channel number c is c + 0.125: exact in a half, too.
inline render::ExrPart test_part(std::string name, std::vector<std::string> channels, int width = 4,
                                 int height = 3) {
  render::ExrPart part;
  part.name = std::move(name);
  part.display_window = part.data_window = {0, 0, width, height};
  part.pixels = render::FloatBuffer(width, height, std::move(channels));
  for (std::size_t c = 0; c < part.pixels.channel_count(); ++c) {
    for (float& sample : part.pixels.channel(c))
      sample = static_cast<float>(c) + 0.125F;
  }
  return part;
}

inline ComparedPicture test_picture(std::vector<render::ExrPart> parts) {
  return {"picture.exr", PixelEncoding::light, std::move(parts)};
}

}  // namespace alhazen
