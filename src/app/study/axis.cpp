#include "app/study/axis.h"

#include <cmath>

namespace alhazen {
namespace {

constexpr double kRoom = 0.06;        // of the axis, at each end
constexpr double kShortest = 0.7;     // decades
constexpr double kManyDecades = 2.5;  // more than these, and 2 and 5 are lines without numbers

}  // namespace

double LogAxis::place(double value) const {
  return std::log(value / low) / std::log(high / low);
}

LogAxis log_axis(double low, double high, std::string (*label)(double)) {
  double from = std::log10(low), to = std::log10(high);
  const double missing = kShortest - (to - from);
  if (missing > 0) from -= missing / 2, to += missing / 2;
  const double room = kRoom * (to - from);
  from -= room, to += room;
  LogAxis axis{std::pow(10, from), std::pow(10, to), {}};
  const bool sparse = to - from > kManyDecades;
  for (int decade = static_cast<int>(std::floor(from)); decade <= to; ++decade) {
    for (const int digit : {1, 2, 5}) {
      const double value = digit * std::pow(10, decade);
      if (value < axis.low || value > axis.high) continue;
      axis.ticks.push_back({value, digit == 1 || !sparse ? label(value) : ""});
    }
  }
  return axis;
}

}  // namespace alhazen
