#include "app/compare/figures.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace alhazen {
namespace {

std::optional<OddPair> odd_kind(double a, double b) {
  if (std::isnan(a)) return std::isnan(b) ? OddPair::nan_in_both : OddPair::nan_in_a;
  if (std::isnan(b)) return OddPair::nan_in_b;
  if (std::isfinite(a) && std::isfinite(b)) return std::nullopt;
  return a == b ? OddPair::equal_infinity : OddPair::unequal_infinity;
}

void count_odd(OddCount& odd, std::uint64_t count, PixelPlace first) {
  const auto order = [](PixelPlace p) { return std::pair(p.row, p.column); };
  if (count > 0 && (odd.count == 0 || order(first) < order(odd.first))) odd.first = first;
  odd.count += count;
}

}  // namespace

FigureSums::FigureSums(std::span<const float> a, std::span<const float> b, int width,
                       const Tolerance& tolerance) {
  PixelPlace place;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (is_over(a[i], b[i], tolerance)) ++counts_.over;
    add_pair(a[i], b[i], place);
    if (++place.column == width) place = {0, place.row + 1};
  }
  counts_.pairs = a.size();
}

void FigureSums::add_pair(double a, double b, PixelPlace place) {
  if (const auto kind = odd_kind(a, b)) {
    count_odd(counts_.odd[static_cast<std::size_t>(*kind)], 1, place);
    if (*kind == OddPair::equal_infinity) ++counts_.compared;
    return;
  }
  const double error = std::fabs(a - b);
  squares_ += error * error;
  relative_squares_ += error * error / (b * b + kRelativeEpsilon);
  absolutes_ += error;
  ++counts_.compared;
  if (error > counts_.largest.error) counts_.largest = {error, place, a, b};
}

void FigureSums::drop_means() {
  squares_ = relative_squares_ = absolutes_ = 0.0;
  counts_.compared = 0;
  counts_.largest = {};
}

void FigureSums::add(const FigureSums& other) {
  squares_ += other.squares_;
  relative_squares_ += other.relative_squares_;
  absolutes_ += other.absolutes_;
  counts_.pairs += other.counts_.pairs;
  counts_.compared += other.counts_.compared;
  counts_.over += other.counts_.over;
  if (other.counts_.largest.error > counts_.largest.error) {
    counts_.largest = other.counts_.largest;
  }
  for (std::size_t kind = 0; kind < kOddPairs; ++kind) {
    count_odd(counts_.odd[kind], other.counts_.odd[kind].count, other.counts_.odd[kind].first);
  }
}

Figures FigureSums::figures(double peak) const {
  Figures figures = counts_;
  const double count = static_cast<double>(counts_.compared);  // 0 makes the means 0 / 0
  figures.mse = squares_ / count;
  figures.rmse = std::sqrt(figures.mse);
  figures.relative_mse = relative_squares_ / count;
  figures.mae = absolutes_ / count;
  figures.psnr = figures.mse == 0.0 ? std::numeric_limits<double>::infinity()
                                    : 10.0 * std::log10(peak * peak / figures.mse);
  return figures;
}

}  // namespace alhazen
