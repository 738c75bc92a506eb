// app/study: an axis of logarithms.
#pragma once

#include <string>
#include <vector>

namespace alhazen {

struct AxisTick {
  double value = 0;
  std::string label;  // empty: a line without a number
};

struct LogAxis {
  double low = 0, high = 0;  // both positive, low < high
  std::vector<AxisTick> ticks;

  // 0 at `low`, 1 at `high`.
  double place(double value) const;
};

// An axis that holds both values, with some room, and at least two numbers on it: every power of
// ten, and 2 and 5 between where there are few of those. Preconditions: positive, low <= high.
LogAxis log_axis(double low, double high, std::string (*label)(double));

}  // namespace alhazen
