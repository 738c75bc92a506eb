// app/study: a scene in, everything that accuracy costs there out.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/study/budget.h"
#include "app/study/front.h"
#include "app/study/reference.h"
#include "app/study/study_picture.h"
#include "app/study/timing.h"
#include "core/diag/source.h"
#include "render/color/color_transform.h"

namespace alhazen {

struct StudyInput {
  std::string name;    // as the report shows it
  const Scene& scene;  // with the size to be studied
  const std::vector<render::ImagePixels>& images;
  const SourceManager& sources;
  DisplayLook look;                   // for FLIP
  render::ColorTransform view;        // for the pictures that are shown
  int own_width = 0, own_height = 0;  // of the scene's picture, whose times are told too
};

struct StudyOptions {
  double seconds = 120;  // for the scene, about, on a machine that does nothing else
  int threads = 1;
  std::optional<render::Isa> isa;
  int runs = 3;  // of each setting, in turn
  bool with_povray = false;
  std::string povray = "povray";
  const std::atomic<bool>* cancel = nullptr;
};

struct StudyPoint {
  StudySetting setting;
  Spread cpu, wall;  // seconds
  int runs = 0;
  render::RenderStatistics statistics;  // of the first run; empty for POV-Ray
  double samples_a_pixel = 0;
  PictureErrors errors;                   // against the converged picture
  std::optional<double> truncation_rmse;  // against the reference's depth and cutoff, same samples
  double floor = 0;                       // the smallest RMSE that can be shown here
  StudyPictures pictures;

  bool is_shown() const { return errors.rmse > floor; }
  bool is_povray() const { return setting.knob >= Knob::povray_method_1; }
  CostPoint cost() const { return {cpu.median, errors.rmse}; }
};

// One scalar type against quad.
struct RoundingPoint {
  render::Precision precision = render::Precision::float64;
  Spread cpu;
  PictureErrors errors;
};
struct RoundingStudy {
  int samples = 0;
  std::vector<RoundingPoint> points;  // float, double, quad (whose errors are 0)

  // How many times smaller double's error is than float's; nothing when double's is 0.
  std::optional<double> gain() const;
};

struct FilterReference {
  FilterKind filter = FilterKind::box;
  int samples = 0;
  double own_error = 0;
};

struct PovrayStudy {
  std::vector<std::string> deviations;  // what it cannot say exactly
  bool own_reference = false;           // errors are against its own converged picture
  std::string reference;                // how that was made
  double floor = 0;
  double from_ours = 0;  // RMSE of its converged picture against ours
  std::string failure;   // why there are no points
};

struct SceneStudy {
  std::string name;
  int width = 0, height = 0, own_width = 0, own_height = 0;
  int threads = 1, runs = 0;
  render::Isa isa = render::Isa::baseline;
  double seconds = 0, budget = 0;
  RenderSettings reference;  // the main one
  double sampling_error = 0, truncation_error = 0;
  std::vector<FilterReference> filter_references;
  std::vector<StudyPoint> points;
  std::optional<RoundingStudy> rounding;
  std::optional<PovrayStudy> povray;
  std::vector<LeftOut> left_out;

  const StudyPoint& scene_point() const;
  double floor() const;
};

// `step` says what is being done, `share` is of the whole scene's time, as far as it is known.
using StudyListener = std::function<void(const std::string& step, double share)>;

// Fails as render::render does, for the reasons of a picture that cannot be made at all, and with
// ErrorCode::stopped. That POV-Ray is not there, or cannot render the scene, is told in the study.
Result<SceneStudy> study_scene(const StudyInput& input, const StudyOptions& options,
                               const StudyListener& listen = {});

}  // namespace alhazen
