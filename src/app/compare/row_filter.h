// app/compare: separable convolution, one row of the result at a time, so that no picture of what
// lies between the two passes is kept.
#pragma once

#include <span>
#include <vector>

namespace alhazen {

// Weights for the offsets -radius .. radius.
using Kernel = std::vector<double>;

// exp(-x^2 / (2 sigma^2)) at whole x, scaled to the sum 1.
Kernel gaussian_kernel(double sigma, int radius);

struct PlaneView {
  std::span<const float> samples;
  int width{}, height{};
};

// Beyond its edges a picture goes on with its outermost pixels.
class RowFilter {
 public:
  RowFilter(int width, int radius);

  // The row of the plane after the pass from top to bottom; several across() may follow.
  // Precondition for both: the kernel has the radius of the filter.
  void down(const PlaneView& plane, int row, const Kernel& kernel);
  // The pass from left to right of that row, times `weight`, added to `sums`, one for each column.
  void add_across(const Kernel& kernel, double weight, std::span<double> sums) const;

 private:
  std::size_t width_, radius_;
  std::vector<double> padded_;  // the row with `radius` more samples at both ends
};

}  // namespace alhazen
