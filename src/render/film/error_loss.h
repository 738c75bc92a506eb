// render/film: what a pixel's variance costs in the measure in which a
// picture's error is asked for. The picture's loss is the mean of its pixels'.
#pragma once

#include <algorithm>
#include <array>

#include "core/math/scalar.h"
#include "core/scene/settings.h"

namespace alhazen::render {

class ErrorLoss {
 public:
  explicit ErrorLoss(const ErrorTarget& target) : target_(target) {}

  bool counts_pixels() const { return target_.share > 0; }

  // The square of a change of R, G and B: of their mean square, or of the channel that is off most.
  double squared(const std::array<double, 3>& change) const {
    const double r = change[0] * change[0], g = change[1] * change[1], b = change[2] * change[2];
    return counts_pixels() ? std::max({r, g, b}) : (r + g + b) / 3;
  }

  // Of a pixel whose mean has this variance, as far as that is known: the variance itself, or the
  // probability that the mean is off by more than the target. The variance is an estimate of few
  // degrees of freedom; eight, for Student's distribution, which then has the closed form
  //   P(|T| > t) = 1 - s (1 + c / 2 + 3 c^2 / 8 + 5 c^3 / 16),
  //   s^2 = t^2 / (8 + t^2), c = 1 - s^2.
  double of(double variance) const {
    if (!counts_pixels()) return variance;
    if (!(variance > 0)) return 0;
    const double t2 = target_.error * target_.error / variance, c = 8 / (8 + t2);
    return 1 - square_root(t2 / (8 + t2)) * (1 + c * (0.5 + c * (0.375 + c * 0.3125)));
  }

  // Of a pixel for which a square has come out whose expectation is its variance: that is itself
  // off by more than the target as often as the pixel is, and no distribution is assumed.
  double of_square(double square) const {
    if (!counts_pixels()) return square;
    return square > target_.error * target_.error ? 1 : 0;
  }

  // The variance of a mean of two of_square(), and of what it stands for, about their expectation,
  // if the mean came out as `loss`. For squares X it has E X^2 = 2 V^2 and variance V^2, and the
  // picture's own luck is a square, of variance 2 V^2. For counts of probability p it has p (1 - p)
  // / 2, the luck twice that; 1 - p is taken from `variance`, which is better known.
  double noise(double loss, double variance) const {
    return counts_pixels() ? 1.5 * loss * (1 - of(variance)) : 1.5 * loss * loss;
  }

  // The picture's loss may be this.
  double goal() const {
    return counts_pixels() ? 1 - target_.share : target_.error * target_.error;
  }
  // The picture's loss in the words of the target: RMSE, or the share of pixels that are off.
  double value(double loss) const { return counts_pixels() ? loss : square_root(loss); }

 private:
  ErrorTarget target_;
};

}  // namespace alhazen::render
