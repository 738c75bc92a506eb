// render/wave: one tile of the picture: which samples its pixels still want, in batches, until all
// have what they ask for.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "render/film/error_control.h"
#include "render/film/pixel_accumulator.h"
#include "render/wave/center_ray.h"
#include "render/wave/coverage.h"
#include "render/wave/deadline.h"
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
 private:
  struct Pixel {
    std::int32_t x, y;
    std::uint32_t taken = 0, wanted = 0;
  };
  using Accumulator = PixelAccumulator<4>;  // of radiance and alpha
  // Of each pixel, if there are data channels at all.
  struct PixelData {
    RunningMoments<3> albedo;
    std::uint64_t rays = 0;
    std::uint64_t signature = 0;  // a sum: the order of samples does not matter
    float margin = 1;
    CoverageCounter objects, materials;
  };

 public:
  // A tile's samples so far, between the passes over a picture.
  class Kept {
    friend TileRenderer;
    std::vector<Pixel> pixels_;
    std::vector<Accumulator> sums_;
    std::vector<PixelData> data_;
  };

  explicit TileRenderer(const TileJob<Real>& job)
      : job_(job),
        batch_samples_(batch_samples(job)),
        integrator_(job.world, job.plan, job.options.cancel, 2 * batch_samples_) {
    const AovRequest& aovs = job.options.aovs;
    wants_.first_surface =
        aovs.albedo || aovs.object_ids || aovs.material_ids || job.settings.transparent_background;
    wants_.signature = aovs.signature;
    wants_.margin = aovs.margin;
    wants_.rays = aovs.cost;
  }

  // Renders `tile`, a part of `picture.window`, into the picture. False when the run was cancelled.
  bool render(PixelRect tile, Picture& picture);

  // One pass: gives each pixel what `control` wants it to have and tells what that has changed.
  // False when the run was cancelled or the time was up; `kept` then has what was finished.
  bool add_samples(PixelRect tile, const Deadline& deadline, PixelRect window,
                   ErrorControl& control, Kept& kept);
  void finish(Kept& kept, Picture& picture);

  // The radiance of the first sample of each of these pixels; not a part of any picture. False when
  // the run was cancelled.
  struct Place {
    std::int32_t x, y;
  };
  bool probe(std::span<const Place> places, std::span<std::array<double, 4>> radiance);

  const WaveCounters& counters() const { return integrator_.wave().counters; }
  std::uint64_t samples() const { return samples_; }
  // Rays through the centres of pixels, for data channels.
  std::uint64_t center_rays() const { return center_rays_; }
  double largest_dropped_weight() const { return largest_dropped_weight_; }

 private:
  // The samples [first, first + count) of a pixel.
  struct SampleRange {
    std::size_t pixel;
    std::uint32_t first, count;
  };

  // A pixel that gets samples in a pass: its means before and half way.
  using Value = typename Accumulator::Value;
  struct Wanting {
    std::size_t pixel;
    std::uint32_t wanted;
    Value before, middle;
  };

  void start(PixelRect tile);
  void list_pixels(PixelRect tile, std::uint32_t samples);
  bool run_wanted();
  bool run_batch(const std::vector<SampleRange>& spans);
  void collect(const std::vector<SampleRange>& spans);
  void collect_data(std::size_t slot, std::uint32_t sample, PixelData& data);
  bool want_more();
  bool find_wanting();
  void finish(Picture& picture);
  void swap_with(Kept& kept);
  void finish_data(const Pixel& pixel, const PixelData& data, std::size_t p, Picture& picture);

  // Camera samples followed at once: fewer where each of them asks many samples of the lights.
  static std::size_t batch_samples(const TileJob<Real>& job) {
    const std::size_t asked = job.options.limits.generation_rays;
    if (asked > 0) return asked;
    return std::clamp<std::size_t>(kBatchPaths / job.world.light_samples(), 64, 2048);
  }
  // So that the queues of a generation, some 500 bytes an entry, fit into a second-level cache.
  static constexpr std::size_t kBatchPaths = std::size_t{1} << 13;

  TileJob<Real> job_;
  std::size_t batch_samples_;
  Integrator<Real> integrator_;
  SlotWants wants_;
  std::vector<Pixel> pixels_;
  // Parallel to pixels_: the means of single samples, which are those samples, or else what adds
  // many up. One of the two is empty.
  std::vector<Accumulator::Value> single_;
  std::vector<Accumulator> sums_;
  std::vector<PixelData> data_;     // parallel to pixels_, or empty
  std::vector<SampleRange> spans_;  // of the batch
  std::vector<Wanting> wanting_;
  Deadline deadline_;
  std::uint64_t samples_ = 0, center_rays_ = 0;
  double largest_dropped_weight_ = 0;
};

}  // namespace alhazen::render
