// app/study: the slopes that theory expects, as lines on the chart.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study/front.h"

namespace alhazen {

// error ~ time^-slope. `label` is the exponent: of N samples, to which time is proportional.
struct Guide {
  double slope = 0;
  std::string label;
};

// 1/2: independent samples (Monte Carlo). 3/4: one stratified sample a cell, where a few edges
// cross the pixel (D. P. Mitchell, "Consequences of Stratified Sampling in Graphics", 1996).
// 1: even grids at best. 3/2: scrambled nets where the picture is smooth within the pixel (A. B.
// Owen, "Scrambled Net Variance for Integrals of Smooth Functions", 1997).
std::vector<Guide> usual_guides();

// A rectangle of the chart, all positive.
struct CostRange {
  double seconds_low = 0, seconds_high = 0, error_low = 0, error_high = 0;
};

// The line through `anchor`, from there to where it leaves the range, below or at the right.
// Nothing if the anchor is not inside.
std::optional<std::pair<CostPoint, CostPoint>> guide_line(const Guide& guide, CostPoint anchor,
                                                          const CostRange& range);

// The slope of the straight line that fits best in logarithms (least squares): about -0.75 for
// stratified edges. Nothing for fewer than two times.
std::optional<double> fitted_slope(const std::vector<CostPoint>& points);

}  // namespace alhazen
