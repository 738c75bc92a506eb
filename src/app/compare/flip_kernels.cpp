#include "app/compare/flip_kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace alhazen {
namespace {

// One Gaussian of the paper's table 1: a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
  double a, b;
};
constexpr std::array<Sensitivity, 1> kAchromatic{{{1.0, 0.0047}}};
constexpr std::array<Sensitivity, 1> kRedGreen{{{1.0, 0.0053}}};
constexpr std::array<Sensitivity, 2> kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidest = 0.04;  // the largest b

// exp(-pi^2 d^2 / b) is a Gaussian of this sigma, in degrees.
double sigma_of(double b) {
  return std::sqrt(b / 2.0) / std::numbers::pi;
}

int three_sigma(double sigma) {
  return static_cast<int>(std::ceil(3.0 * sigma));
}

GaussianSum gaussian_sum(std::span<const Sensitivity> table, double pixels_per_degree, int radius) {
  GaussianSum terms;
  double total = 0.0;
  for (const auto& [a, b] : table) {
    const double sigma = sigma_of(b) * pixels_per_degree;
    GaussianTerm term{0.0, gaussian_kernel(sigma, radius)};
    // What gaussian_kernel divided by, in both directions: the middle weight was exp(0) = 1.
    const double sum = 1.0 / term.kernel[static_cast<std::size_t>(radius)];
    term.weight = a * std::sqrt(std::numbers::pi / b) * sum * sum;
    total += term.weight;
    terms.push_back(std::move(term));
  }
  for (GaussianTerm& term : terms)
    term.weight /= total;
  return terms;
}

void balance(Kernel& kernel) {
  double above = 0.0, below = 0.0;
  for (const double weight : kernel)
    (weight > 0.0 ? above : below) += std::fabs(weight);
  for (double& weight : kernel)
    weight /= weight > 0.0 ? above : below;
}

}  // namespace

SensitivityKernels sensitivity_kernels(double pixels_per_degree) {
  const int radius = three_sigma(sigma_of(kWidest) * pixels_per_degree);
  return {radius,
          {gaussian_sum(kAchromatic, pixels_per_degree, radius),
           gaussian_sum(kRedGreen, pixels_per_degree, radius),
           gaussian_sum(kBlueYellow, pixels_per_degree, radius)}};
}

FeatureKernels feature_kernels(double pixels_per_degree) {
  constexpr double kFeatureWidth = 0.082;  // degrees, of what the eye sees best
  const double sigma = 0.5 * kFeatureWidth * pixels_per_degree;
  const int radius = three_sigma(sigma);
  FeatureKernels kernels{radius, gaussian_kernel(sigma, radius), {}, {}};
  for (int x = -radius; x <= radius; ++x) {
    const double gaussian = kernels.smooth[static_cast<std::size_t>(x + radius)];
    const double steps = x / sigma;
    kernels.first.push_back(-steps * gaussian);
    kernels.second.push_back((steps * steps - 1.0) * gaussian);
  }
  balance(kernels.first);
  balance(kernels.second);
  return kernels;
}

}  // namespace alhazen
