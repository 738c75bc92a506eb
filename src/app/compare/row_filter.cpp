#include "app/compare/row_filter.h"

#include <algorithm>
#include <cmath>

namespace alhazen {

Kernel gaussian_kernel(double sigma, int radius) {
  Kernel kernel;
  double sum = 0.0;
  for (int x = -radius; x <= radius; ++x) {
    kernel.push_back(std::exp(-x * x / (2.0 * sigma * sigma)));
    sum += kernel.back();
  }
  for (double& weight : kernel)
    weight /= sum;
  return kernel;
}

RowFilter::RowFilter(int width, int radius)
    : width_(static_cast<std::size_t>(width)),
      radius_(static_cast<std::size_t>(radius)),
      padded_(width_ + 2 * radius_) {}

void RowFilter::down(const PlaneView& plane, int row, const Kernel& kernel) {
  const std::span<double> sums = std::span(padded_).subspan(radius_, width_);
  std::ranges::fill(sums, 0.0);
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    const int source = row + static_cast<int>(k) - static_cast<int>(radius_);
    const auto y = static_cast<std::size_t>(std::clamp(source, 0, plane.height - 1));
    const std::span<const float> samples = plane.samples.subspan(y * width_, width_);
    const double weight = kernel[k];
    for (std::size_t x = 0; x < width_; ++x)
      sums[x] += weight * static_cast<double>(samples[x]);
  }
  std::fill_n(padded_.begin(), radius_, sums.front());
  std::fill_n(padded_.end() - static_cast<std::ptrdiff_t>(radius_), radius_, sums.back());
}

void RowFilter::add_across(const Kernel& kernel, double weight, std::span<double> sums) const {
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    const double factor = weight * kernel[k];
    const std::span<const double> samples = std::span(padded_).subspan(k, width_);
    for (std::size_t x = 0; x < width_; ++x)
      sums[x] += factor * samples[x];
  }
}

}  // namespace alhazen
