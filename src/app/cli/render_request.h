// app/cli: what `alhazen render` was asked for, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/settings.h"
#include "parser/eval/evaluate.h"
#include "render/wave/render.h"

namespace alhazen {

enum class ProgressStyle { automatic, bar, plain, json, none };
enum class SamplePrecision { half, float32 };

struct PictureSize {
  int width = 0, height = 0;
};

// Settings that the command line puts in the place of the scene's.
struct SettingOverrides {
  std::optional<PictureSize> size;
  std::optional<int> samples, max_depth;
  std::optional<double> adaptive_threshold, cutoff;
  std::optional<ReconstructionFilter> filter;
  std::optional<std::uint64_t> seed;
  std::optional<ErrorTarget> max_error;  // an error of 0: none, whatever the scene says
  std::optional<ErrorTarget> preset;
};

struct RenderRequest {
  std::string scene;
  std::vector<parser::Define> defines;
  parser::FileAccess files = parser::FileAccess::below_scene;

  std::string output;   // "-": stdout
  std::string preview;  // empty: none
  SettingOverrides settings;
  std::optional<render::PixelRect> crop;
  render::AovRequest aovs;
  render::Precision precision = render::Precision::float64;
  SamplePrecision beauty = SamplePrecision::half;
  int threads = 0;
  double time_limit = 0;           // seconds for max_error; 0: none
  std::optional<render::Isa> isa;  // empty: the widest that runs here

  std::string color_file, display, view;  // empty: the default

  std::vector<int> frames;  // empty: one picture that is no frame
  bool skip_existing = false;

  ProgressStyle progress = ProgressStyle::automatic;
  std::string statistics;  // "-": stdout; empty: no JSON
  bool quiet = false;
};

}  // namespace alhazen
