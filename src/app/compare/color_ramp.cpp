#include "app/compare/color_ramp.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace alhazen {
namespace {

// Evenly spaced; between them the codes are interpolated.
constexpr std::array<std::array<double, 3>, 7> kStops{{{6, 5, 18},
                                                       {52, 20, 92},
                                                       {122, 30, 118},
                                                       {190, 52, 96},
                                                       {238, 104, 64},
                                                       {252, 180, 86},
                                                       {254, 248, 204}}};

std::uint8_t between(double low, double high, double share) {
  return static_cast<std::uint8_t>(std::lround(low + share * (high - low)));
}

}  // namespace

std::array<std::uint8_t, 3> ramp_color(double value) {
  const double in_range = std::isnan(value) ? 0.0 : std::clamp(value, 0.0, 1.0);
  const double at = in_range * static_cast<double>(kStops.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  std::array<std::uint8_t, 3> color{};
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = between(kStops[low][c], kStops[low + 1][c], at - static_cast<double>(low));
  }
  return color;
}

std::vector<std::uint8_t> ramp_picture(std::span<const float> values, double scale) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * values.size());
  for (const float value : values) {
    const std::array<std::uint8_t, 3> color = ramp_color(static_cast<double>(value) / scale);
    bytes.insert(bytes.end(), color.begin(), color.end());
  }
  return bytes;
}

Html ramp_legend(const std::string& low, const std::string& high) {
  std::string stops;
  for (const auto& stop : kStops)
    stops += fmt::format(", rgb({} {} {})", stop[0], stop[1], stop[2]);
  const Html bar =
      html_line("div", "\u00a0", {{"style", "background: linear-gradient(to right" + stops + ")"}});
  return html_element("div", html_line("span", low) + bar + html_line("span", high),
                      {{"class", "ramp"}});
}

}  // namespace alhazen
