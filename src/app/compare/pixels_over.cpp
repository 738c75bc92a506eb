#include "app/compare/pixels_over.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alhazen {
namespace {

double error(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::infinity();
  return std::fabs(a - b);
}

}  // namespace

PixelsOver pixels_over(std::span<const PlanePair> channels, int width, const Tolerance& tolerance) {
  PixelsOver result;
  const std::size_t count = channels.empty() ? 0 : channels.front().a.size();
  const auto columns = static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < count; ++i) {
    PixelOver pixel{{static_cast<int>(i % columns), static_cast<int>(i / columns)}};
    for (const PlanePair& channel : channels) {
      const Tolerance allowed = channel.ids ? Tolerance{} : tolerance;
      if (!is_over(channel.a[i], channel.b[i], allowed)) continue;
      ++pixel.channels;
      pixel.largest_error = std::max(pixel.largest_error, error(channel.a[i], channel.b[i]));
    }
    if (pixel.channels == 0) continue;
    result.over += static_cast<std::uint64_t>(pixel.channels);
    result.pixels.push_back(pixel);
  }
  result.samples = count * channels.size();
  return result;
}

}  // namespace alhazen
