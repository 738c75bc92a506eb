// app/compare: how far two values may be apart and still pass for the same.
#pragma once

#include <algorithm>
#include <cmath>

namespace alhazen {

// `value` passes for `reference` when |value - reference| <= max(absolute, relative |reference|).
// The default lets only equal values pass: 0 and -0, two infinities of one sign, and two NaNs,
// which say the same: that there is no number.
struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;
};

// A NaN against a number is over any tolerance; so is an infinity against anything but itself,
// although infinity <= infinity would let it pass.
inline bool is_over(double value, double reference, const Tolerance& tolerance) {
  if (value == reference || (std::isnan(value) && std::isnan(reference))) return false;
  if (!std::isfinite(value) || !std::isfinite(reference)) return true;
  return std::fabs(value - reference) >
         std::max(tolerance.absolute, tolerance.relative * std::fabs(reference));
}

}  // namespace alhazen
