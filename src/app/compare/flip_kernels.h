// app/compare: the filters of FLIP: what the eye blurs, and what it finds.
#pragma once

#include <array>
#include <vector>

#include "app/compare/row_filter.h"

namespace alhazen {

// A sum of Gaussians, each the product of one kernel with itself, across and down:
// sum of weight * kernel(x) * kernel(y). Every kernel sums to 1, and so do the weights.
struct GaussianTerm {
  double weight = 1.0;
  Kernel kernel;
};
using GaussianSum = std::vector<GaussianTerm>;

// The contrast sensitivity of the eye as filters for Y_y, C_x and C_z, all of one radius.
struct SensitivityKernels {
  int radius = 0;
  std::array<GaussianSum, 3> channels;
};
SensitivityKernels sensitivity_kernels(double pixels_per_degree);

// Derivatives of a Gaussian, which answer to edges and to points and lines. In each derivative the
// weights above 0 sum to 1 and those below to -1.
struct FeatureKernels {
  int radius = 0;
  Kernel smooth;  // the Gaussian: across the direction of the derivative
  Kernel first, second;
};
FeatureKernels feature_kernels(double pixels_per_degree);

}  // namespace alhazen
