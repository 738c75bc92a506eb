#include "app/study/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace alhazen {

std::vector<std::size_t> pareto_front(std::span<const CostPoint> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const CostPoint &p = points[a], &q = points[b];
    return p.seconds != q.seconds ? p.seconds < q.seconds : p.error < q.error;
  });
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t index : order) {
    if (!(points[index].error < best)) continue;
    best = points[index].error;
    front.push_back(index);
  }
  return front;
}

std::optional<TimeAtError> time_at_error(std::span<const CostPoint> front, double error) {
  for (std::size_t i = 0; i < front.size(); ++i) {
    const CostPoint& here = front[i];
    if (here.error > error) continue;
    if (i == 0) return TimeAtError{here.seconds, here.error < error};
    const CostPoint& before = front[i - 1];
    const double along = std::log(error / before.error) / std::log(here.error / before.error);
    return TimeAtError{before.seconds * std::pow(here.seconds / before.seconds, along), false};
  }
  return std::nullopt;
}

}  // namespace alhazen
