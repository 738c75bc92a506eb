#include "app/compare/ssim.h"

#include <algorithm>
#include <array>
#include <vector>

#include "app/compare/display_values.h"
#include "app/compare/row_filter.h"

namespace alhazen {
namespace {

// a, b, a^2, b^2, a b: their local means give means, variances and covariance.
using Moments = std::array<double, 5>;

// The moments of a window's columns, weighted from top to bottom; for the windows whose first row
// is `top`.
void moments_down(const render::FloatBuffer& a, const render::FloatBuffer& b, int top,
                  const Kernel& kernel, std::vector<Moments>& columns) {
  std::ranges::fill(columns, Moments{});
  for (int k = 0; k < static_cast<int>(kernel.size()); ++k) {
    const double weight = kernel[static_cast<std::size_t>(k)];
    for (int x = 0; x < a.width(); ++x) {
      const double p = a.at(0, x, top + k), q = b.at(0, x, top + k);
      Moments& sums = columns[static_cast<std::size_t>(x)];
      sums[0] += weight * p;
      sums[1] += weight * q;
      // Brackets: the index must not depend on which picture comes first.
      sums[2] += weight * (p * p);
      sums[3] += weight * (q * q);
      sums[4] += weight * (p * q);
    }
  }
}

Moments moments_across(std::span<const Moments> columns, const Kernel& kernel) {
  Moments sums{};
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += kernel[k] * columns[k][i];
  }
  return sums;
}

// Equation 13 of the paper.
double index(const Moments& m) {
  const double mean_products = m[0] * m[1], mean_squares = m[0] * m[0] + m[1] * m[1];
  const double covariance = m[4] - mean_products;
  const double variances = m[2] + m[3] - mean_squares;
  return (2.0 * mean_products + kSsimC1) * (2.0 * covariance + kSsimC2) /
         ((mean_squares + kSsimC1) * (variances + kSsimC2));
}

}  // namespace

render::FloatBuffer luma(const render::FloatBuffer& light) {
  render::FloatBuffer codes(light.width(), light.height(), {"Y"});
  for (std::size_t i = 0; i < light.pixel_count(); ++i) {
    const double code = 0.2126 * srgb_code(light.channel(0)[i]) +
                        0.7152 * srgb_code(light.channel(1)[i]) +
                        0.0722 * srgb_code(light.channel(2)[i]);
    codes.channel(0)[i] = static_cast<float>(code);
  }
  return codes;
}

std::optional<double> mean_ssim(const render::FloatBuffer& a, const render::FloatBuffer& b) {
  constexpr int kWindow = 2 * kSsimRadius + 1;
  if (a.width() < kWindow || a.height() < kWindow) return std::nullopt;
  const Kernel kernel = gaussian_kernel(kSsimSigma, kSsimRadius);
  std::vector<Moments> columns(static_cast<std::size_t>(a.width()));
  double sum = 0.0;
  const int across = a.width() - kWindow + 1, down = a.height() - kWindow + 1;
  for (int top = 0; top < down; ++top) {
    moments_down(a, b, top, kernel, columns);
    for (std::size_t left = 0; left < static_cast<std::size_t>(across); ++left)
      sum += index(moments_across(std::span(columns).subspan(left, kWindow), kernel));
  }
  return sum / (static_cast<double>(across) * down);
}

}  // namespace alhazen
