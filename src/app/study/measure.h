// app/study: settings to measured points.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "app/study/study.h"

namespace alhazen {

// One picture: what its runs gave so far.
struct Measured {
  StudySetting setting;
  std::vector<double> cpu, wall;
  StudyPoint point;  // all but the times
};

// Each picture once: a setting that stands on two curves is rendered for both.
std::vector<Measured> different_settings(std::span<const StudySetting> settings);

// The points of `settings`, in their order, from what was measured of them.
std::vector<StudyPoint> points_of(std::span<const StudySetting> settings,
                                  std::span<const Measured> measured);

struct Measuring {
  const RenderRun& run_;
  const std::map<FilterKind, Reference>& references;
  const std::optional<RgbPicture>& untruncated;  // comparing_samples(), the reference's depth
  ThumbnailWindow window;
  const DisplayLook& look;
  const render::ColorTransform& view;

  // Renders once more; the first time errors and pictures are made too.
  Status run(Measured& measured) const;
};

// float, double and quad of the same samples. `setting` is that of quad, which runs once.
Result<RoundingStudy> measure_rounding(const RenderRun& run, const StudySetting& setting, int runs,
                                       const DisplayLook& look);

// The largest number among the area lights that cast shadows; 1 without any.
int most_light_samples(const Scene& scene);

}  // namespace alhazen
