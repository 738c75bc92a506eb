// render/wave: the workers of a picture that is made in several passes: each keeps its queues from
// one pass to the next.
#pragma once

#include <atomic>
#include <ctime>
#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "render/wave/stopwatch.h"
#include "render/wave/tile_pass.h"

namespace alhazen::render {

inline double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Real>
class Crew {
 public:
  struct Worker {
    explicit Worker(const TileJob<Real>& job) : renderer(job) {}
    TileRenderer<Real> renderer;
    double cpu_seconds = 0, elapsed_seconds = 0;
  };

  Crew(const TileJob<Real>& job, int threads) {
    for (int k = 0; k < threads; ++k)
      workers_.push_back(std::make_unique<Worker>(job));
  }

  int size() const { return static_cast<int>(workers_.size()); }
  const std::vector<std::unique_ptr<Worker>>& workers() const { return workers_; }

  // Calls work(renderer, i) for every i in [0, count), until a call gives false; then false.
  template <class Work>
  bool for_all(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stopped{false};
    in_parallel(size(), workers_.size(), [&](std::size_t k) {
      Worker& worker = *workers_[k];
      const double cpu_before = thread_cpu_seconds();
      Stopwatch stopwatch;
      for (std::size_t i = next.fetch_add(1); i < count && !stopped; i = next.fetch_add(1)) {
        if (!work(worker.renderer, i)) stopped = true;
      }
      worker.cpu_seconds += thread_cpu_seconds() - cpu_before;
      worker.elapsed_seconds += stopwatch.lap();
    });
    return !stopped;
  }

 private:
  std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace alhazen::render
