// render/wave: one tile of the picture: which samples its pixels still want, in batches, until all
// have what they ask for.
#pragma once

#include <algorithm>
#include <vector>

#include "render/film/pixel_accumulator.h"
#include "render/wave/center_ray.h"
#include "render/wave/coverage.h"
#include "render/wave/integrate.h"

namespace alhazen::render {

// Everything that all tiles share and none changes.
template <class Real>
struct TileJob {
  const World<Real>& world;
  const StagePlan& plan;
  const RenderSettings& settings;
  const Camera& camera;
  const RenderOptions& options;
};

template <class Real>
class TileRenderer {
 public:
  static constexpr int kTileSize = 16;  // pixels on each side

  explicit TileRenderer(const TileJob<Real>& job)
      : job_(job),
        integrator_(job.world, job.plan, job.options.cancel),
        batch_samples_(
            std::clamp<std::size_t>(kMaxBatchPaths / job.world.light_samples(), 16, 4096)) {}

  // Renders `tile`, a part of `picture.window`, into the picture. False when the run was cancelled.
  bool render(PixelRect tile, Picture& picture);

  const WaveCounters& counters() const { return integrator_.wave().counters; }
  std::uint64_t samples() const { return samples_; }
  // Rays through the centres of pixels, for data channels.
  std::uint64_t center_rays() const { return center_rays_; }
  double largest_dropped_weight() const { return largest_dropped_weight_; }

 private:
  struct Pixel {
    std::int32_t x, y;
    std::uint32_t taken = 0, wanted = 0;
    PixelAccumulator<4> radiance;  // and alpha
    RunningMoments<3> albedo;
    std::uint64_t rays = 0;
    std::uint64_t signature = 0;  // a sum: the order of samples does not matter
    float margin = 1;
    CoverageCounter objects, materials;
  };
  // The samples [first, first + count) of a pixel.
  struct SampleRange {
    std::size_t pixel;
    std::uint32_t first, count;
  };

  void start(PixelRect tile);
  bool run_wanted();
  bool run_batch(const std::vector<SampleRange>& spans);
  void collect(const std::vector<SampleRange>& spans);
  bool want_more();
  bool find_wanting();
  void finish(Picture& picture);

  TileJob<Real> job_;
  Integrator<Real> integrator_;
  std::vector<Pixel> pixels_;
  // Camera samples followed at once: fewer where each of them asks many samples of the lights.
  static constexpr std::size_t kMaxBatchPaths = std::size_t{1} << 16;
  std::size_t batch_samples_;
  std::uint64_t samples_ = 0, center_rays_ = 0;
  double largest_dropped_weight_ = 0;
};

}  // namespace alhazen::render
