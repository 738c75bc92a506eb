// render/film: what one sample a pixel tells about the noise, from how
// neighbours differ.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "render/film/error_loss.h"

namespace alhazen::render {

// The first sample of each pixel of a picture.
class FirstLook {
 public:
  using Value = std::array<float, 3>;

  FirstLook(const ErrorLoss& loss, int width, int height)
      : loss_(loss),
        width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  // Different pixels may be set at the same time.
  void set(std::size_t p, const Value& value) { values_[p] = value; }
  const Value& value(std::size_t p) const { return values_[p]; }

  // Half of the mean square of what pixel `p`, if it had this value, and its neighbours differ by:
  // the variance of a sample, if the pixels are alike and only noise sets them apart. An edge or a
  // dot shows, too, and so does what is smooth but not constant; hence this says where to look
  // first, and is no estimate by itself.
  double difference(std::size_t p, const Value& value) const;
  double difference(std::size_t p) const { return difference(p, values_[p]); }

  // Gives back the memory; there are no values afterwards.
  void forget() { values_ = {}; }

 private:
  ErrorLoss loss_;
  int width_, height_;
  std::vector<Value> values_;
};

inline double FirstLook::difference(std::size_t p, const Value& value) const {
  const int y = static_cast<int>(p / static_cast<std::size_t>(width_));
  const int x = static_cast<int>(p % static_cast<std::size_t>(width_));
  double sum = 0, weights = 0;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j) {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i) {
      if (i == x && j == y) continue;
      const double weight = i == x || j == y ? 2 : 1;
      const Value& other = values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(i)];
      sum += weight * loss_.squared({double{value[0]} - other[0], double{value[1]} - other[1],
                                     double{value[2]} - other[2]});
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights / 2 : 0;
}

}  // namespace alhazen::render
