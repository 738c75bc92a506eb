// app/study: what the points say, in plain sentences.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/study.h"

namespace alhazen {

// Indices of the points that are shown, of this renderer or of POV-Ray, on their Pareto front.
std::vector<std::size_t> front_of(const SceneStudy& study, bool povray);

// Without pictures of other filters, whose references are others: their errors can be compared,
// but another filter is another picture.
bool is_comparable(const SceneStudy& study, const StudyPoint& point);

// CPU seconds until an error is reached, here and in POV-Ray.
struct EqualError {
  double rmse = 0;
  std::optional<TimeAtError> ours, povray;

  // How many times as long POV-Ray takes; nothing when one does not reach the error, or when either
  // is faster than anything that was measured.
  std::optional<double> ratio() const;
};
inline constexpr double kEqualErrors[] = {0.01, 0.003, 0.001};
std::vector<EqualError> equal_errors(const SceneStudy& study);

// "at most 12 ms", "1.3 s", "not reached".
std::string time_text(const std::optional<TimeAtError>& time);

// How many times the scene's own time half of its error takes; nothing when that is not shown.
std::optional<double> halving_cost(const SceneStudy& study);

// The smallest value of `knob` whose truncation is below a tenth of `error`, and the point; points
// of one knob. Nothing when none is.
const StudyPoint* enough(const SceneStudy& study, Knob knob, double error);

// Of ours what is not as in the scene's own; of POV-Ray's the method and its words.
std::string setting_text(const SceneStudy& study, const StudyPoint& point);

// In the order in which they matter; each ends with a full stop.
std::vector<std::string> conclusions(const SceneStudy& study);

}  // namespace alhazen
