// render/wave: a scene in, a picture and its figures out. The library's whole rendering interface.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "render/wave/isa.h"
#include "render/wave/plan.h"

namespace alhazen::render {

enum class Precision { float32, float64, quad };

// A picture that textures and the background read: linear, in the working space, rows from the top.
struct ImagePixels {
  int width = 0, height = 0;
  std::vector<float> rgb;  // 3 * width * height
};

struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;  // from the top left corner of the frame
};

// What is kept besides the picture itself. Z, P, N and uv are those of the ray through the centre
// of the pixel; the others are of all camera samples.
//
// The signature is a hash of everything that the pixel's rays decided: the shape, face and side
// each of them met or that it met nothing, whether it was totally reflected, and whether light
// arrived. Textures, and the choice of a medium's list, are not in it. The margin is how near the
// nearest of these decisions was to falling the other way, as a share of the numbers that were
// compared (shape/doubt.h): 0 is a tie.
struct AovRequest {
  bool depth = false, normal = false, position = false, uv = false, albedo = false;
  bool object_ids = false, material_ids = false, samples = false, cost = false;
  bool signature = false, margin = false;
  // The estimated standard error of the pixel; there with RenderSettings::max_error only, and then
  // asked for or not.
  bool error = false;

  // Whether something is to be kept of each sample, or of the ray through the pixel's centre.
  bool any() const {
    return depth || normal || position || uv || albedo || object_ids || material_ids || samples ||
           cost || signature || margin;
  }
};

// How work is cut. It changes no bit of any picture; tests use it to show that. 0: as measured
// best.
struct WorkLimits {
  int tile_size = 0;                // pixels on each side
  std::size_t generation_rays = 0;  // followed at once
};

struct RenderOptions {
  Precision precision = Precision::float64;
  PixelRect crop;          // empty: the whole frame
  int threads = 0;         // 0: one a core
  std::optional<Isa> isa;  // empty: the widest that runs here; no bit depends on it
  AovRequest aovs;
  const std::atomic<bool>* cancel = nullptr;  // looked at between batches
  // Seconds after which sampling for RenderSettings::max_error ends with what there is; 0: never.
  // Each pixel has a sample at least, and some have two.
  double time_limit = 0;
  WorkLimits limits;
};

// The share of a pixel's samples that saw an object or a material, largest first.
struct Coverage {
  std::uint32_t id;  // index into Scene::shapes or Scene::materials
  float share;
};

// All planes cover the crop, rows from the top; those not asked for are empty.
struct Picture {
  PixelRect window;
  std::vector<double> rgb;  // radiance in the working space, 3 a pixel
  std::vector<float>
      alpha;  // 1, or the share of samples that met something (transparent_background)
  std::vector<float> depth;  // along the camera's forward axis; infinite where nothing is
  std::vector<float> normal, position;  // 3 a pixel, world; 0 where nothing is
  std::vector<float> uv;                // 2 a pixel
  std::vector<float> albedo;            // 3 a pixel
  std::vector<float> samples, cost;     // camera samples; rays of all kinds
  std::vector<std::uint64_t> signature;
  std::vector<float> margin;
  std::vector<float> error;  // of max_error: the mean's standard error
  std::vector<std::vector<Coverage>> objects, materials;
};

struct StageCost {
  StageId stage;
  std::uint64_t rays = 0;  // items that went through it
  double cpu_seconds = 0;  // its share, by elapsed time, of the workers' CPU time
};

struct RenderStatistics {
  std::uint64_t camera_rays = 0, reflection_rays = 0, refraction_rays = 0, shadow_rays = 0;
  std::uint64_t cut_by_depth = 0, cut_by_weight = 0;  // children that were not traced
  double dropped_weight_max = 0;  // of any sample: largest channel of the weight that was cut
  std::uint64_t samples = 0;
  std::vector<StageCost> stages;  // in the order of the plan
  double wall_seconds = 0, cpu_seconds = 0;
  int threads = 0;
  Isa isa = Isa::baseline;

  std::uint64_t rays() const {
    return camera_rays + reflection_rays + refraction_rays + shadow_rays;
  }
};

enum class AccuracyEnd {
  reached,
  out_of_time,     // RenderOptions::time_limit came first
  out_of_samples,  // pixels that need more have kMaxSamples
  out_of_depth,    // light still comes from beyond the deepest rays that are followed
};

// What came of RenderSettings::max_error. Errors are in the target's measure: RMSE, or the share of
// pixels that are off by more than it says.
struct AccuracyReport {
  ErrorTarget target;
  AccuracyEnd end = AccuracyEnd::reached;
  double estimate = 0;  // of the error, whatever it comes from
  double bound = 0;     // at most this with `confidence`
  double confidence = 0;
  double truncation = 0;  // RMS of the light beyond max_depth and cutoff, as estimated
  int max_depth = 0;      // that were chosen
  double cutoff = 0;
  int passes = 0;
};

struct RenderOutput {
  Picture picture;
  RenderStatistics statistics;
  std::optional<AccuracyReport> accuracy;  // with RenderSettings::max_error
  StagePlan plan;
};

// Called from worker threads, never from two at once; `done` of `total` pixels.
using ProgressListener = std::function<void(std::uint64_t done, std::uint64_t total)>;

// Renders `scene` with its settings as they stand. `images` parallels Scene::images. The picture is
// a function of scene, images, precision and crop alone: the same bits for any number of threads
// and any instruction set; unless it ran out of time.
// Errors: usage for a crop outside of the frame, unsupported for quad or an instruction set that is
// not there, limit when memory runs out, stopped when the run was cancelled.
Result<RenderOutput> render(const Scene& scene, const std::vector<ImagePixels>& images,
                            const RenderOptions& options, const ProgressListener& progress = {});

}  // namespace alhazen::render
