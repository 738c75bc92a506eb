// render/wave: the loop. Generation after generation of a batch's rays goes through the planned
// stages until none is left: no recursion, the same stack at any depth (T. Whitted 1980, turned
// inside out: the radiance of a ray tree is linear, so each ray carries its share).
#pragma once

#include <atomic>
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
  // More rays than `max_generation` in one generation are cut into parts, each followed to its end
  // before the next, so that the queues stay within a few times as many entries. Cuts fall between
  // camera samples, which changes no sum. Only when one sample alone has more is it cut itself, at
  // a place that follows from its own rays and from nothing else.
  Integrator(const World<Real>& world, const StagePlan& plan, const std::atomic<bool>* cancel)
      : wave_(world),
        start_(stage_functions<Real>(plan.start)),
        generation_(stage_functions<Real>(plan.generation)),
        cancel_(cancel),
        max_generation_(kMaxLightPaths / world.light_samples()) {}

  Wave<Real>& wave() { return wave_; }
  const Wave<Real>& wave() const { return wave_; }

  // Follows every ray of every sample in wave().slots to its end; false when it was cancelled.
  bool run_batch() {
    wave_.media.clear();
    wave_.rays.clear();
    first_generation_ = true;
    for (const StageCall<Real>& stage : start_)
      run(stage, wave_.slots.size());
    wave_.counters.camera_rays += wave_.rays.size();
    std::vector<RayQueue<Real>> waiting;
    for (;;) {
      while (!wave_.rays.empty()) {
        if (cancel_ != nullptr && cancel_->load()) return false;
        if (wave_.rays.size() > max_generation_) set_aside(waiting);
        run_generation();
      }
      if (waiting.empty()) return true;
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
    if (id >= StageId::ambient_on_matte && id <= StageId::rectangle_on_pov) {
      const std::size_t lists[] = {wave_.matte.size(), wave_.glossy.size(), wave_.coat.size(),
                                   wave_.pov.size()};
      return lists[(static_cast<int>(id) - static_cast<int>(StageId::ambient_on_matte)) % 4];
    }
    switch (id) {
      case StageId::closest_hits:
      case StageId::interfaces:
      case StageId::absorb:
      case StageId::sign_hits:
      case StageId::weigh_hits:
        return wave_.rays.size();
      case StageId::escape:
      case StageId::environment:
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
      case StageId::pov_glow:
        return wave_.pov_glowing.size();
      case StageId::pov_reflection:
        return wave_.pov_mirror.size();
      case StageId::pov_transmission:
        return wave_.pov_clear.size();
      default:
        return wave_.hits.size();
    }
  }

  void run(const StageCall<Real>& stage, std::size_t items) {
    const double before = thread_cpu_seconds();
    stage.function(wave_);
    wave_.counters.add(stage.id, items, thread_cpu_seconds() - before);
  }

  // Moves rays to `waiting` until at most max_generation_ are left: those of the later samples, or,
  // of a single sample, those beyond the first max_generation_.
  void set_aside(std::vector<RayQueue<Real>>& waiting) {
    wave_.rays.group_by_sample();
    while (wave_.rays.size() > max_generation_) {
      const std::size_t cut = wave_.rays.cut_near(wave_.rays.size() / 2);
      waiting.push_back(wave_.rays.split_off(cut > 0 ? cut : max_generation_));
    }
  }

  // Entries that the queue of light paths may come to hold, 150 bytes or so each.
  static constexpr std::size_t kMaxLightPaths = std::size_t{1} << 18;

  Wave<Real> wave_;
  std::vector<StageCall<Real>> start_, generation_;
  const std::atomic<bool>* cancel_;
  std::size_t max_generation_;
  bool first_generation_ = true;
};

}  // namespace alhazen::render
