// render/film: mean and variance of a stream of values (B. P. Welford, Technometrics 4(3), 1962).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace alhazen::render {

// A stream of equal values has exactly that mean and variance 0, however long it is; in general the
// mean's rounding error is below `count` units of rounding of the largest value.
template <std::size_t Channels>
class RunningMoments {
 public:
  void add(const std::array<double, Channels>& value) {
    ++count_;
    for (std::size_t i = 0; i < Channels; ++i) {
      const double before = value[i] - mean_[i];
      mean_[i] += before / static_cast<double>(count_);
      squares_[i] += before * (value[i] - mean_[i]);
    }
  }

  std::uint32_t count() const { return count_; }
  double mean(std::size_t channel) const { return mean_[channel]; }
  // Of the mean, estimated; 0 for fewer than two values, which say nothing about their spread.
  double variance_of_mean(std::size_t channel) const {
    if (count_ < 2) return 0;
    const double n = count_;
    return squares_[channel] / (n - 1) / n;
  }

 private:
  std::array<double, Channels> mean_{}, squares_{};
  std::uint32_t count_ = 0;
};

}  // namespace alhazen::render
