// render/wave: the loop. Generation after generation of a batch's rays goes through the planned
// stages until none is left: no recursion, the same stack at any depth (T. Whitted 1980, turned
// inside out: the radiance of a ray tree is linear, so each ray carries its share).
#pragma once

#include <ctime>
#include <utility>
#include <vector>

#include "render/wave/stage_table.h"

namespace alhazen::render {

inline double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Real>
class Integrator {
 public:
  // More rays than this in one generation are cut into parts, each followed to its end before the
  // next: memory stays bounded. Cuts fall between camera samples, so they change no sum.
  static constexpr std::size_t kMaxGeneration = std::size_t{1} << 16;

  Integrator(const World<Real>& world, const StagePlan& plan)
      : wave_(world),
        start_(stage_functions<Real>(plan.start)),
        generation_(stage_functions<Real>(plan.generation)) {}

  Wave<Real>& wave() { return wave_; }
  const Wave<Real>& wave() const { return wave_; }

  // Follows every ray of every sample in wave().slots to its end.
  void run_batch() {
    wave_.media.clear();
    wave_.rays.clear();
    first_generation_ = true;
    for (const StageCall<Real>& stage : start_)
      run(stage, wave_.slots.size());
    wave_.counters.camera_rays += wave_.rays.size();
    std::vector<RayQueue<Real>> waiting;
    for (;;) {
      while (!wave_.rays.empty()) {
        if (wave_.rays.size() > kMaxGeneration) set_aside(waiting);
        run_generation();
      }
      if (waiting.empty()) return;
      wave_.rays = std::move(waiting.back());
      waiting.pop_back();
    }
  }

 private:
  void run_generation() {
    wave_.start_generation();
    if (!wave_.world.has_shapes()) wave_.escape_all();
    for (const StageCall<Real>& stage : generation_)
      run(stage, items_of(stage.id));
    if (first_generation_) wave_.keep_first_surfaces();
    first_generation_ = false;
    std::swap(wave_.rays, wave_.next);
    wave_.next.clear();
  }

  // How much work a stage has before it, for the figures.
  std::size_t items_of(StageId id) const {
    switch (id) {
      case StageId::closest_hits:
        return wave_.rays.size();
      case StageId::escape:
        return wave_.escaped.size();
      case StageId::emission:
        return wave_.glowing.size();
      case StageId::unshadowed:
        return wave_.unshadowed.size();
      case StageId::opaque_shadows:
      case StageId::tinted_shadows:
        return wave_.light_paths.size();
      case StageId::mirror:
        return wave_.mirror.size();
      case StageId::metal:
        return wave_.metal.size();
      case StageId::coat:
        return wave_.coat.size();
      case StageId::glass:
        return wave_.glass.size();
      default:
        return wave_.hits.size();
    }
  }

  void run(const StageCall<Real>& stage, std::size_t items) {
    const double before = thread_cpu_seconds();
    stage.function(wave_);
    const auto index = static_cast<std::size_t>(stage.id);
    wave_.counters.stage_items[index] += items;
    wave_.counters.stage_seconds[index] += thread_cpu_seconds() - before;
  }

  // Moves the rays of the later samples to `waiting`, at most kMaxGeneration at a time where the
  // samples' own trees allow it.
  void set_aside(std::vector<RayQueue<Real>>& waiting) {
    const std::size_t half = wave_.rays.cut_near(wave_.rays.size() / 2);
    if (half == 0 || half == wave_.rays.size()) return;
    waiting.push_back(wave_.rays.split_off(half));
    if (wave_.rays.size() > kMaxGeneration) set_aside(waiting);
  }

  Wave<Real> wave_;
  std::vector<StageCall<Real>> start_, generation_;
  bool first_generation_ = true;
};

}  // namespace alhazen::render
