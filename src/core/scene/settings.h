// core/scene: how the picture is to be made. The scene proposes, the command line overrides.
#pragma once

#include <cstdint>
#include <optional>

#include "core/diag/source.h"

namespace alhazen {

// What settings may be, from a scene as from the command line.
inline constexpr int kMaxImageSide = 65536;
inline constexpr int kMaxSamples = 1 << 20;
inline constexpr int kMaxDepth = 1'000'000;
inline constexpr double kMinError = 1e-6, kMaxError = 1;
inline constexpr double kMinFilterRadius = 0.5, kMaxFilterRadius = 16;
inline constexpr std::int64_t kMaxSeed = std::int64_t{1} << 53;  // every one is a double, too

// The most samples of a pixel where sampling is adaptive and nobody says how many.
inline constexpr int kAdaptiveSamples = 1024;

enum class FilterKind { box, tent, gaussian, mitchell };

struct ReconstructionFilter {
  FilterKind kind = FilterKind::box;
  double radius = 0.5;  // in pixels; each kind has its own usual value (render/film)
};

// Adaptive sampling stops a pixel when the standard error of its mean, largest of the channels, is
// at most `threshold`, between `min_samples` and RenderSettings::samples, which is larger.
struct AdaptiveSampling {
  double threshold = 0.01;
  int min_samples = 16;
};

// How wrong the picture may be, against the one that infinitely many samples, reflections and
// refractions would give. In units of the picture: 1 is a display's white.
struct ErrorTarget {
  double error = 1.0 / 255;
  // 0: the root of the mean square, over all pixels and R, G, B, is at most `error`. Otherwise: of
  // this share of the pixels, no channel is off by more than `error`.
  double share = 0;
};

struct RenderSettings {
  int width = 640, height = 360;
  int samples = 16;  // per pixel; 1 means the pixel's centre
  std::optional<AdaptiveSampling> adaptive;
  // In the place of samples, adaptive, max_depth and cutoff, which the renderer then chooses.
  std::optional<ErrorTarget> max_error;
  int max_depth = 16;         // reflections and refractions along a path; 0: none
  double cutoff = 1.0 / 512;  // a ray whose largest weight is below it is not traced; 0: all are
  ReconstructionFilter filter;
  bool transparent_background = false;  // alpha 0 where a camera ray meets nothing
  std::uint64_t seed = 0;
  SourceSpan span;
};

}  // namespace alhazen
