// app/study: the same scene in POV-Ray, at its ways of anti-aliasing.
#pragma once

#include "app/study/study.h"

namespace alhazen {

struct PovraySetting {
  Knob knob = Knob::povray_method_2;
  std::string label;
  std::vector<std::string> words;  // of its command line
  int blur_samples = 0;            // through a lens; 0: the scene has none
};

// Methods 1 and 2, thresholds and depths; through a lens, where POV-Ray's own samples do the
// anti-aliasing, numbers of those. In the order of importance.
std::vector<PovraySetting> povray_settings(bool has_lens);

// A grid of n x n points in a pixel that edges cross errs by n^-3/2; the error of the finer of two
// grids, one with twice as many points on a side as the other, by how they differ.
double error_of_finer_grid(double difference);
// The same of N samples of which nothing is known but that they are independent: N^-1/2, and the
// other picture has half as many.
double error_of_more_samples(double difference);

struct PovraySweep {
  PovrayStudy study;
  std::vector<StudyPoint> points;
  double seconds = 0;  // that it took, as StudyOptions counts them
};

// `input.scene` with the settings that both programs render with; `converged` is our picture of
// box-filtered pixels. Fails with ErrorCode::stopped alone: whatever else goes wrong is told in
// PovrayStudy::failure.
Result<PovraySweep> sweep_povray(const StudyInput& input, const StudyOptions& options,
                                 const Reference& converged, const ThumbnailWindow& window,
                                 double seconds, const StudyListener& listen);

}  // namespace alhazen
