// render/wave: the whole picture in one scalar type: tiles handed out to workers, figures added up.
// Included where it is instantiated, once a scalar type.
#pragma once

#include <chrono>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "core/base/parallel.h"
#include "render/wave/crew.h"
#include "render/wave/tile_render.h"

namespace alhazen::render {

// What render() has checked and decided before a scalar type comes in.
struct RenderJob {
  const Scene& scene;
  const std::vector<ImagePixels>& images;
  const RenderOptions& options;
  const StagePlan& plan;
  PixelRect window;
  const ProgressListener& progress;
};

// Cuts the window into tiles of `size` x `size` pixels, those of its last quarter into smaller ones
// so that the workers end together.
inline std::vector<PixelRect> tiles_of(PixelRect window, int size) {
  const int small = std::max(1, size / 2);
  std::vector<PixelRect> tiles;
  int y = 0;
  while (y < window.height) {
    const int side = 4 * y < 3 * window.height ? size : small;
    for (int x = 0; x < window.width; x += side) {
      tiles.push_back({window.x + x, window.y + y, std::min(side, window.width - x),
                       std::min(side, window.height - y)});
    }
    y += side;
  }
  return tiles;
}

// Large tiles give full queues; there are to be enough for every worker to be busy all the time.
inline int tile_size(PixelRect window, std::size_t workers) {
  constexpr int kLargest = 32, kSmallest = 8;
  constexpr std::int64_t kTilesOfAWorker = 16;
  const std::int64_t pixels = std::int64_t{window.width} * window.height;
  int size = kLargest;
  while (size > kSmallest &&
         pixels < kTilesOfAWorker * static_cast<std::int64_t>(workers) * size * size) {
    size /= 2;
  }
  return size;
}

// What the workers share.
struct TileQueue {
  std::vector<PixelRect> tiles;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::mutex mutex;  // of everything below, of the listener and of the statistics
  std::uint64_t pixels_done = 0;
  std::exception_ptr failure;  // the first of a worker
};

// `busy`: the share of the worker's elapsed time that it had a core to itself.
inline void add_figures(const WaveCounters& from, const StagePlan& plan, double busy,
                        RenderStatistics& to) {
  to.camera_rays += from.camera_rays;
  to.reflection_rays += from.reflection_rays;
  to.refraction_rays += from.refraction_rays;
  to.shadow_rays += from.shadow_rays;
  to.cut_by_depth += from.cut_by_depth;
  to.cut_by_weight += from.cut_by_weight;
  std::size_t k = 0;
  plan.for_each([&](const PlannedStage& stage) {
    if (to.stages.size() <= k) to.stages.push_back({stage.id, 0, 0});
    to.stages[k].rays += from.stage_items[static_cast<std::size_t>(stage.id)];
    to.stages[k].cpu_seconds += busy * from.stage_seconds[static_cast<std::size_t>(stage.id)];
    ++k;
  });
}

// Of a worker that has done its part: `elapsed` seconds, `cpu` of them on a core.
template <class Real>
void add_figures(const TileRenderer<Real>& renderer, const StagePlan& plan, double cpu,
                 double elapsed, RenderStatistics& to) {
  add_figures(renderer.counters(), plan, elapsed > 0 ? cpu / elapsed : 1, to);
  to.samples += renderer.samples();
  to.camera_rays += renderer.center_rays();
  to.dropped_weight_max = std::max(to.dropped_weight_max, renderer.largest_dropped_weight());
  to.cpu_seconds += cpu;
}

template <class Real>
void work(const TileJob<Real>& job, const RenderJob& whole, TileQueue& queue, Picture& picture,
          RenderStatistics& statistics) {
  const double cpu_before = thread_cpu_seconds();
  Stopwatch stopwatch;
  TileRenderer<Real> renderer(job);
  for (;;) {
    const std::size_t index = queue.next.fetch_add(1);
    if (index >= queue.tiles.size() || queue.stopped.load()) break;
    const PixelRect tile = queue.tiles[index];
    if (!renderer.render(tile, picture)) {
      queue.stopped = true;
      break;
    }
    if (!whole.progress) continue;
    const std::lock_guard lock(queue.mutex);
    queue.pixels_done += static_cast<std::uint64_t>(tile.width) * tile.height;
    whole.progress(queue.pixels_done, static_cast<std::uint64_t>(whole.window.width) *
                                          static_cast<std::uint64_t>(whole.window.height));
  }
  const double cpu = thread_cpu_seconds() - cpu_before;
  const double elapsed = stopwatch.lap();
  const std::lock_guard lock(queue.mutex);
  add_figures(renderer, job.plan, cpu, elapsed, statistics);
}

inline void make_planes(PixelRect window, const AovRequest& aovs, Picture& picture) {
  const std::size_t pixels =
      static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
  const auto plane = [pixels](bool wanted, std::vector<float>& values, std::size_t channels) {
    if (wanted) values.resize(channels * pixels);
  };
  picture.window = window;
  picture.rgb.resize(3 * pixels);
  picture.alpha.resize(pixels);
  plane(aovs.depth, picture.depth, 1);
  plane(aovs.normal, picture.normal, 3);
  plane(aovs.position, picture.position, 3);
  plane(aovs.uv, picture.uv, 2);
  plane(aovs.albedo, picture.albedo, 3);
  plane(aovs.samples, picture.samples, 1);
  plane(aovs.cost, picture.cost, 1);
  plane(aovs.margin, picture.margin, 1);
  plane(aovs.error, picture.error, 1);
  if (aovs.signature) picture.signature.resize(pixels);
  if (aovs.object_ids) picture.objects.resize(pixels);
  if (aovs.material_ids) picture.materials.resize(pixels);
}

template <class Real>
Result<RenderOutput> render_scene(const RenderJob& whole) {
  const auto started = std::chrono::steady_clock::now();
  RenderOutput output;
  output.plan = whole.plan;
  make_planes(whole.window, whole.options.aovs, output.picture);
  const World<Real> world(whole.scene, whole.images, thread_count(whole.options.threads));
  const TileJob<Real> job{world, output.plan, whole.scene.settings, whole.scene.camera,
                          whole.options};
  TileQueue queue;
  const auto asked = static_cast<std::size_t>(thread_count(whole.options.threads));
  const int size = whole.options.limits.tile_size;
  queue.tiles = tiles_of(whole.window, size > 0 ? size : tile_size(whole.window, asked));
  const std::size_t wanted = std::min(asked, queue.tiles.size());
  const auto work_safely = [&]() noexcept {
    try {
      work(job, whole, queue, output.picture, output.statistics);
    } catch (...) {
      const std::lock_guard lock(queue.mutex);
      if (!queue.failure) queue.failure = std::current_exception();
      queue.stopped = true;
    }
  };
  std::size_t threads = 1;
  {
    std::vector<std::jthread> workers;
    try {
      for (; threads < wanted; ++threads)
        workers.emplace_back(work_safely);
    } catch (const std::system_error&) {
      // The system gives no more threads: those there are do all the work.
    }
    work_safely();
  }
  if (queue.failure) std::rethrow_exception(queue.failure);
  if (queue.stopped.load()) return Error{ErrorCode::stopped, "stopped before it was done"};
  output.statistics.threads = static_cast<int>(threads);
  output.statistics.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return output;
}

}  // namespace alhazen::render
