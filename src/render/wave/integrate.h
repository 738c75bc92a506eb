// render/wave: the loop. Generation after generation of a batch's rays goes through the planned
// stages until none is left: no recursion, the same stack at any depth (T. Whitted 1980, turned
// inside out: the radiance of a ray tree is linear, so each ray carries its share).
#pragma once

#include <atomic>
#include <utility>
#include <vector>

#include "render/wave/stage_table.h"
#include "render/wave/stopwatch.h"
#include "render/wave/waiting_rays.h"
#include "render/wave/wave.h"

namespace alhazen::render {

template <class Real>
class Integrator {
 public:
  Integrator(const World<Real>& world, const StagePlan& plan, const std::atomic<bool>* cancel,
             std::size_t generation_rays)
      : wave_(world),
        start_(stage_functions<Real>(plan.start)),
        generation_(stage_functions<Real>(plan.generation)),
        colored_(plan.runs(StageId::plain_colors) || plan.runs(StageId::textured_colors)),
        cancel_(cancel),
        waiting_(generation_rays,
                 std::max<std::size_t>(1, kMaxLightPaths / world.light_samples())) {}

  Wave<Real>& wave() { return wave_; }
  const Wave<Real>& wave() const { return wave_; }

  // Follows every ray of every sample in wave().slots to its end; false when it was cancelled.
  bool run_batch() {
    wave_.media.forget_much();
    wave_.rays.clear();
    waiting_.clear();
    stopwatch_.restart();
    for (const StageCall<Real>& stage : start_)
      run(stage, wave_.slots.size());
    wave_.counters.camera_rays += wave_.rays.size();
    for (;;) {
      while (!wave_.rays.empty()) {
        if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return false;
        waiting_.set_aside(wave_.rays, wave_.slots.size());
        run_generation();
      }
      if (waiting_.empty()) return true;
      waiting_.resume(wave_.rays);
    }
  }

 private:
  void run_generation() {
    wave_.start_generation();
    if (!wave_.world.has_shapes()) wave_.escape_all();
    for (const StageCall<Real>& stage : generation_)
      run(stage, items_of(stage.id));
    if (!wave_.slots.first_shape.empty()) wave_.keep_first_surfaces(colored_);
    std::swap(wave_.rays, wave_.next);
    wave_.next.clear();
  }

  // How much work a stage has before it, for the figures.
  std::size_t items_of(StageId id) const {
    if (id >= StageId::ambient_on_matte && id <= StageId::rectangle_on_pov) {
      constexpr SurfaceKind kLit[] = {SurfaceKind::matte, SurfaceKind::glossy, SurfaceKind::coat,
                                      SurfaceKind::pov};
      const int place = static_cast<int>(id) - static_cast<int>(StageId::ambient_on_matte);
      return wave_.of(kLit[place % 4]).size();
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
        return wave_.of(SurfaceKind::mirror).size();
      case StageId::metal:
        return wave_.of(SurfaceKind::metal).size();
      case StageId::coat:
        return wave_.of(SurfaceKind::coat).size();
      case StageId::glass:
        return wave_.of(SurfaceKind::glass).size();
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

  // Stages with nothing to do are not called.
  void run(const StageCall<Real>& stage, std::size_t items) {
    if (items == 0) return;
    stage.function(wave_);
    wave_.counters.add(stage.id, items, stopwatch_.lap());
  }

  // Entries that the queue of light paths may come to hold, 150 bytes or so each.
  static constexpr std::size_t kMaxLightPaths = std::size_t{1} << 18;

  Wave<Real> wave_;
  std::vector<StageCall<Real>> start_, generation_;
  bool colored_;  // the plan finds colours
  const std::atomic<bool>* cancel_;
  WaitingRays<Real> waiting_;
  Stopwatch stopwatch_;
};

}  // namespace alhazen::render
