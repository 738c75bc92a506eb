#include "app/compare/display_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "render/color/rgb_matrix.h"

namespace alhazen {
namespace {

// In no space of colours is y 0 for the white, and a matrix of primaries on a line is singular.
bool spans_colors(const Chromaticities& c) {
  const double area =
      (c.green.x - c.red.x) * (c.blue.y - c.red.y) - (c.blue.x - c.red.x) * (c.green.y - c.red.y);
  return c.white.y > 0.0 && std::isfinite(area) && area != 0.0;
}

// NaN to 0, and what no float holds to the nearest that one does.
double usable(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return std::isnan(value) ? 0.0 : std::clamp(value, -kMost, kMost);
}

}  // namespace

double srgb_code(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

double srgb_light(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

std::optional<Chromaticities> chromaticities_of(const render::ExrPart& part) {
  const auto found = part.attributes.find("chromaticities");
  if (found == part.attributes.end()) return std::nullopt;
  std::istringstream text(found->second);
  Chromaticities c;
  for (Xy* xy : {&c.red, &c.green, &c.blue, &c.white})
    text >> xy->x >> xy->y;
  if (!text || !spans_colors(c)) return std::nullopt;
  return c;
}

ColorMatrix rec709_from(const Chromaticities& space) {
  return render::rgb_from_rgb(kRec709, space);
}

render::FloatBuffer rec709_light(const render::FloatBuffer& picture,
                                 const std::array<std::size_t, 3>& channels,
                                 const DisplayLook& look) {
  render::FloatBuffer light(picture.width(), picture.height(), {"R", "G", "B"});
  const double scale = std::exp2(look.exposure);
  const auto linear = [&](double value) {
    return scale * (look.encoding == PixelEncoding::srgb ? srgb_light(value) : usable(value));
  };
  const auto stored = [](double value) { return static_cast<float>(usable(value)); };
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const Rgbd color = look.rec709 * Rgbd(linear(picture.channel(channels[0])[i]),
                                          linear(picture.channel(channels[1])[i]),
                                          linear(picture.channel(channels[2])[i]));
    light.channel(0)[i] = stored(color.r);
    light.channel(1)[i] = stored(color.g);
    light.channel(2)[i] = stored(color.b);
  }
  return light;
}

render::FloatBuffer display_light(const render::FloatBuffer& picture,
                                  const std::array<std::size_t, 3>& channels,
                                  const DisplayLook& look) {
  render::FloatBuffer light = rec709_light(picture, channels, look);
  for (std::size_t c = 0; c < 3; ++c) {
    for (float& sample : light.channel(c))
      sample = std::clamp(sample, 0.0F, 1.0F);
  }
  return light;
}

}  // namespace alhazen
