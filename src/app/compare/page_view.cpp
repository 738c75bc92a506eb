#include "app/compare/page_view.h"

#include <algorithm>
#include <cmath>

#include "render/color/builtin_config.h"
#include "render/color/preview.h"

namespace alhazen {
namespace {

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

// 0 where there is no finite difference.
double error(float a, float b) {
  const double difference = std::fabs(static_cast<double>(a) - static_cast<double>(b));
  return std::isfinite(difference) ? difference : 0.0;
}

std::vector<std::uint8_t> shown_codes(const render::FloatBuffer& pixels,
                                      const std::array<std::size_t, 3>& channels, double exposure) {
  const double scale = std::exp2(exposure);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * pixels.pixel_count());
  for (std::size_t i = 0; i < pixels.pixel_count(); ++i) {
    for (const std::size_t channel : channels)
      bytes.push_back(byte(srgb_code(scale * srgb_light(pixels.channel(channel)[i]))));
  }
  return bytes;
}

}  // namespace

Result<PageView> PageView::make(const render::ColorConfig& colors, std::string_view display,
                                std::string_view view) {
  const auto working = colors.to_working(render::kLinearRec709);
  if (!working) return working.error();
  const auto transform = colors.display_transform(display, view);
  if (!transform) return transform.error();
  return PageView(working.value(), transform.value());
}

std::vector<std::uint8_t> PageView::shown(const render::FloatBuffer& pixels,
                                          const std::array<std::size_t, 3>& channels,
                                          const DisplayLook& look) const {
  if (look.encoding == PixelEncoding::srgb) return shown_codes(pixels, channels, look.exposure);
  const double scale = std::exp2(look.exposure);
  std::array<std::vector<float>, 3> planes;
  for (std::size_t i = 0; i < pixels.pixel_count(); ++i) {
    const Rgbd color =
        scale * (look.rec709 * Rgbd(pixels.channel(channels[0])[i], pixels.channel(channels[1])[i],
                                    pixels.channel(channels[2])[i]));
    planes[0].push_back(static_cast<float>(color.r));
    planes[1].push_back(static_cast<float>(color.g));
    planes[2].push_back(static_cast<float>(color.b));
  }
  working_from_rec709_.apply({planes[0], planes[1], planes[2]});
  return render::preview_rgb8(view_, planes[0], planes[1], planes[2]);
}

std::vector<std::uint8_t> shown_difference(const PartPair& parts,
                                           const std::array<ChannelPair, 3>& channels, double gain,
                                           PixelEncoding encoding) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * parts.a->pixels.pixel_count());
  for (std::size_t i = 0; i < parts.a->pixels.pixel_count(); ++i) {
    for (const ChannelPair& channel : channels) {
      const float a = parts.a->pixels.channel(channel.a)[i];
      const float b = parts.b->pixels.channel(channel.b)[i];
      const double value = std::min(1.0, gain * error(a, b));
      bytes.push_back(byte(encoding == PixelEncoding::light ? srgb_code(value) : value));
    }
  }
  return bytes;
}

double difference_gain(const PartPair& parts, const std::array<ChannelPair, 3>& channels) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < parts.a->pixels.pixel_count(); ++i) {
    double largest = 0.0;
    for (const ChannelPair& channel : channels) {
      largest = std::max(largest, error(parts.a->pixels.channel(channel.a)[i],
                                        parts.b->pixels.channel(channel.b)[i]));
    }
    if (largest > 0.0) errors.push_back(largest);
  }
  if (errors.empty()) return 1.0;
  const std::size_t rank = (errors.size() - 1) * 99 / 100;
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>(rank);
  std::ranges::nth_element(errors, at);
  return std::exp2(std::floor(std::log2(0.5 / *at)));
}

}  // namespace alhazen
