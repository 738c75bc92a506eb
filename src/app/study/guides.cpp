#include "app/study/guides.h"

#include <algorithm>
#include <cmath>

namespace alhazen {

std::vector<Guide> usual_guides() {
  return {{0.5, "\u2212\u00bd"}, {0.75, "\u2212\u00be"}, {1, "\u22121"}, {1.5, "\u22123/2"}};
}

std::optional<std::pair<CostPoint, CostPoint>> guide_line(const Guide& guide, CostPoint anchor,
                                                          const CostRange& range) {
  const bool inside = anchor.seconds >= range.seconds_low && anchor.seconds <= range.seconds_high &&
                      anchor.error >= range.error_low && anchor.error <= range.error_high;
  if (!inside) return std::nullopt;
  const double to_right = range.seconds_high / anchor.seconds;
  const double to_bottom = std::pow(anchor.error / range.error_low, 1 / guide.slope);
  const double longer = std::min(to_right, to_bottom);
  return std::pair(
      anchor, CostPoint{anchor.seconds * longer, anchor.error * std::pow(longer, -guide.slope)});
}

std::optional<double> fitted_slope(const std::vector<CostPoint>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const CostPoint& p : points) {
    const double s = std::log(p.seconds), e = std::log(p.error);
    n += 1, x += s, y += e, xx += s * s, xy += s * e;
  }
  const double spread = n * xx - x * x;
  if (!(spread > 0)) return std::nullopt;
  return (n * xy - x * y) / spread;
}

}  // namespace alhazen
