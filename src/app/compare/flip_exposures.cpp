#include "app/compare/flip_exposures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace alhazen {
namespace {

constexpr int kMostExposures = 40;

// (a x^2 + b x) / (c x^2 + d x + e)
constexpr double kA = 2.51, kB = 0.03, kC = 2.43, kD = 0.59, kE = 0.14;

// The light that the curve takes to `shown`, which is below a / c: the positive root of
// (a - c s) x^2 + (b - d s) x - e s.
double light_shown_as(double shown) {
  const double p = kA - kC * shown, q = kB - kD * shown, r = -kE * shown;
  return (-q + std::sqrt(q * q - 4.0 * p * r)) / (2.0 * p);
}

std::vector<double> luminances(const render::FloatBuffer& light) {
  std::vector<double> result;
  for (std::size_t i = 0; i < light.pixel_count(); ++i) {
    const double y = 0.2126 * static_cast<double>(light.channel(0)[i]) +
                     0.7152 * static_cast<double>(light.channel(1)[i]) +
                     0.0722 * static_cast<double>(light.channel(2)[i]);
    if (y > 0.0) result.push_back(y);
  }
  return result;
}

}  // namespace

FlipExposures flip_exposures(const render::FloatBuffer& reference) {
  std::vector<double> lit = luminances(reference);
  if (lit.empty()) return {};
  const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
  std::ranges::nth_element(lit, middle);
  const double median = *middle, brightest = std::ranges::max(lit);
  constexpr double kShown = 0.85;
  const double first = std::log2(light_shown_as(kShown) / brightest);
  const double last = std::log2(light_shown_as(kShown) / median);
  const int stops = static_cast<int>(std::ceil(last - first));
  return {first, last, std::clamp(stops, 2, kMostExposures)};
}

double film_curve(double light) {
  const double x = std::max(light, 0.0);
  return std::min(1.0, x * (kA * x + kB) / (x * (kC * x + kD) + kE));
}

render::FloatBuffer tone_mapped(const render::FloatBuffer& light, double exposure) {
  const double scale = std::exp2(exposure);
  render::FloatBuffer result = light;
  for (std::size_t c = 0; c < 3; ++c) {
    for (float& sample : result.channel(c))
      sample = static_cast<float>(film_curve(scale * static_cast<double>(sample)));
  }
  return result;
}

}  // namespace alhazen
