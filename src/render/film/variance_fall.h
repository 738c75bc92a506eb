// render/film: how fast the variances of pixels' means fall as their samples
// are doubled, measured.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/math/scalar.h"
#include "core/scene/settings.h"

namespace alhazen::render {

inline constexpr int kSampleLevels = 21;  // a pixel has 2^level samples, at most kMaxSamples
static_assert(kMaxSamples == 1 << (kSampleLevels - 1));

// Of pixels with n = 2^level samples the new half tells V(n/4) - V(n/2), by its two parts, and
// V(n/2) - V(n), by what it differs from the old half. Where V falls by one factor each time, that
// is the ratio of the two sums, and then V(n) follows from either.
class VarianceFall {
 public:
  VarianceFall() { factors_.fill(kSlowest); }

  // A pixel that has been doubled to `level`, at least 2: both squared
  // (PixelChange). It stands for `weight` pixels: those that were chosen are no
  // fair sample of all, for they were chosen for what the old half showed.
  void add(int level, double weight, double outer, double inner) {
    Sums& sums = sums_[static_cast<std::size_t>(level)];
    sums.outer += weight * outer;
    sums.inner += weight * inner;
    sums.outer_squares += weight * outer * weight * outer;
    sums.inner_squares += weight * inner * weight * inner;
    sums.products += weight * outer * weight * inner;
    ++sums.count;
  }

  // Takes account of all that has been added. A level is expected to be like
  // the one before it, the lowest like random sampling, or better by as much as
  // edges in strata; expectation and measurement count by their variances.
  void settle() {
    double factor = kSlowest, variance = (kFastest - kSlowest) * (kFastest - kSlowest) / 3;
    for (std::size_t level = 2; level < kSampleLevels; ++level) {
      const Sums& sums = sums_[level];
      if (sums.count >= 2 && sums.outer > 0 && sums.inner > 0) {
        const double ratio = sums.inner / sums.outer;
        // That of a ratio of sums: of what the pixels differ from it.
        const double residues =
            sums.inner_squares - 2 * ratio * sums.products + ratio * ratio * sums.outer_squares;
        const double measured =
            larger(0.0, residues) / (sums.outer * sums.outer) * sums.count / (sums.count - 1);
        const double both = measured + variance;
        factor = (measured * factor + variance * ratio) / both;
        variance *= measured / both;
      }
      factors_[level] = std::clamp(factor, kSlowest, kFastest);
      doubts_[level] = square_root(variance) / (factors_[level] - 1);  // of 1 / (factor - 1)
      factor = factors_[level];
      variance += kDrift;
    }
    if (sums_[2].outer > 0) {
      factors_[1] = factors_[2];
      doubts_[1] = doubts_[2];
    }
  }

  // V(n/2) / V(n) for n = 2^level. Of two samples there is no measure: as of four, once there are
  // such.
  double factor(int level) const { return factors_[static_cast<std::size_t>(level)]; }
  // The relative standard error of V(n) that comes from the factor's.
  double doubt(int level) const { return doubts_[static_cast<std::size_t>(level)]; }

 private:
  // Random sampling, and edges in strata: n^(-3/2).
  static constexpr double kSlowest = 2, kFastest = 2.8284271247461901;
  static constexpr double kDrift = 0.05;  // of the factor's variance, from level to level

  struct Sums {
    double outer = 0, inner = 0, outer_squares = 0, inner_squares = 0, products = 0, count = 0;
  };
  std::array<Sums, kSampleLevels> sums_{};
  std::array<double, kSampleLevels> factors_{}, doubts_{};
};

}  // namespace alhazen::render
