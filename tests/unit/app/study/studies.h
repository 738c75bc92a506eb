// tests/unit/app/study: a study written by hand.
#pragma once

#include <string>
#include <utility>

#include "app/study/study.h"

namespace alhazen {

inline StudyPoint point_of(Knob knob, int samples, double seconds, double rmse) {
  StudyPoint point;
  point.setting.knob = knob;
  point.setting.label = std::to_string(samples);
  point.setting.settings.samples = samples;
  point.cpu = point.wall = {seconds, 0.9 * seconds, 1.1 * seconds};
  point.runs = 3;
  point.errors.rmse = rmse;
  point.errors.largest = 10 * rmse;
  point.errors.pixels = 100;
  point.errors.pixels_over = rmse > 0.001 ? 20 : 0;
  point.pictures = {2, 1, std::vector<std::uint8_t>(6, 128), std::vector<std::uint8_t>(6, 0)};
  return point;
}

// Samples 1, 4, 16 (the scene's own), 64 with errors that fall as N^-1; a wasteful combination; and
// a point below the floor.
inline SceneStudy small_study(std::string name = "two <balls> & \"more\"") {
  SceneStudy study;
  study.name = std::move(name);
  study.width = study.height = 10;
  study.own_width = study.own_height = 20;
  study.runs = 3;
  study.reference.samples = 4096;
  study.sampling_error = 1e-5;
  for (const int samples : {1, 4, 16, 64})
    study.points.push_back(point_of(Knob::samples, samples, 0.01 * samples, 0.04 / samples));
  study.points[2].setting.is_scene = true;
  study.points.push_back(point_of(Knob::combination, 8, 0.5, 0.02));
  study.points.push_back(point_of(Knob::samples, 512, 5, 5e-5));
  for (StudyPoint& point : study.points)
    point.floor = study.floor();
  study.left_out.push_back({"light samples", "no light with a face casts shadows"});
  return study;
}

// With POV-Ray three times as slow at every error.
inline SceneStudy study_with_povray() {
  SceneStudy study = small_study("both");
  study.povray.emplace();
  for (const int samples : {1, 4, 16, 64}) {
    study.points.push_back(
        point_of(Knob::povray_method_2, samples, 0.03 * samples, 0.04 / samples));
  }
  return study;
}

}  // namespace alhazen
