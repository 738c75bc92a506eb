// app/study: which settings are worth their time.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace alhazen {

// Both positive.
struct CostPoint {
  double seconds = 0, error = 0;
};

// Indices of the points that no other beats: none is at least as fast and at least as exact, and
// better in one. By time; errors then fall strictly. Of equal points the first.
std::vector<std::size_t> pareto_front(std::span<const CostPoint> points);

struct TimeAtError {
  double seconds = 0;
  bool at_most = false;  // the fastest point is more exact than was asked for
};

// The time at which `front`, as pareto_front gives it, reaches `error`: a straight line between
// neighbours on the log-log chart. Nothing when it does not.
std::optional<TimeAtError> time_at_error(std::span<const CostPoint> front, double error);

}  // namespace alhazen
