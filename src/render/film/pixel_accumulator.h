// render/film: one pixel's samples, weighted by the sign of the reconstruction filter.
#pragma once

#include "core/math/scalar.h"
#include "render/film/filter.h"
#include "render/film/running_moments.h"

namespace alhazen::render {

// The samples are drawn with the density |filter| / (A+ + A-). Their positive and negative parts
// are averaged apart, mean = A+ mean_positive - A- mean_negative: the counts of the two, which vary
// from pixel to pixel, do not enter, so a constant picture comes out constant. With only one of the
// parts present, its mean.
template <std::size_t Channels>
class PixelAccumulator {
 public:
  using Value = std::array<double, Channels>;

  void add(const Value& value, bool negative) { (negative ? negative_ : positive_).add(value); }

  std::uint32_t count() const { return positive_.count() + negative_.count(); }

  Value mean(const Filter& filter) const {
    const Weights weight = weights(filter);
    Value result{};
    for (std::size_t i = 0; i < Channels; ++i)
      result[i] = weight.positive * positive_.mean(i) - weight.negative * negative_.mean(i);
    return result;
  }

  // The standard error of the mean, the largest among the first `channels` (leave out alpha).
  // 0 while the spread of a part is not known yet: ask after a minimum of samples.
  double standard_error(const Filter& filter, std::size_t channels = Channels) const {
    const Weights w = weights(filter);
    double largest = 0;
    for (std::size_t i = 0; i < channels; ++i) {
      largest = larger(largest, w.positive * w.positive * positive_.variance_of_mean(i) +
                                    w.negative * w.negative * negative_.variance_of_mean(i));
    }
    return square_root(largest);
  }

 private:
  struct Weights {
    double positive, negative;
  };
  Weights weights(const Filter& filter) const {
    if (negative_.count() == 0) return {1, 0};
    if (positive_.count() == 0) return {0, -1};
    return {filter.positive_integral(), filter.negative_integral()};
  }

  RunningMoments<Channels> positive_, negative_;
};

}  // namespace alhazen::render
