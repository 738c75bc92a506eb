// app/study: which points fit into the time there is.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/study/sweep_plan.h"

namespace alhazen {

// How the seconds of one scene are shared out.
struct TimeShares {
  double references = 0.6, rounding = 0.08, sweep = 0.32, povray = 0;
};
TimeShares time_shares(bool with_povray);

// What a camera sample of the scene's own settings costs, measured on a few of them.
struct PilotCost {
  double fixed_seconds = 0;     // whatever the number of samples
  double seconds_a_sample = 0;  // one for every pixel, in double
  double shadow_share = 0;      // of the rays: those to area lights
  int scene_light_samples = 1;
};

// For choosing only; the times that are shown are measured.
double predicted_seconds(const StudySetting& setting, const PilotCost& cost);

// Beside double: measured on pictures of this renderer, to the next half power of ten.
inline constexpr double kQuadFactor = 100;

struct BudgetChoice {
  std::vector<StudySetting> kept;  // in the order of the plan
  std::vector<LeftOut> left_out;   // one entry a knob
  double seconds = 0;              // predicted, of all runs
};

// Takes settings in the order of their rank, and within it from the quickest, as long as
// `runs` of each fit into `seconds`. The scene's own setting is always taken.
BudgetChoice choose_for_budget(std::span<const StudySetting> settings, const PilotCost& cost,
                               int runs, double seconds);

// Without those whose samples are more than a sixteenth of the reference's: even where errors fall
// as N^-3/4 they are less than ten times the reference's, and cannot be shown.
inline constexpr std::int64_t kReferenceSamplesATime = 16;
BudgetChoice within_reference(std::span<const StudySetting> settings, int reference_samples);

}  // namespace alhazen
