// render/wave: the whole picture in one scalar type, in passes, until its error is what was asked
// for. Included where it is instantiated, once a scalar type.
#pragma once

#include "render/wave/render_scene.h"
#include "render/wave/truncation.h"

namespace alhazen::render {

// How far a picture has come, for the listener: a share of pixels that never falls, from what has
// been sampled and a guess at what is to come.
class PassProgress {
 public:
  PassProgress(const ProgressListener& listener, PixelRect window)
      : listener_(listener),
        pixels_(static_cast<std::uint64_t>(window.width) *
                static_cast<std::uint64_t>(window.height)) {}

  void begin_pass(double samples_ahead) { whole_ = static_cast<double>(spent_) + samples_ahead; }
  void add(std::uint64_t samples) {
    if (!listener_) return;
    const std::lock_guard lock(mutex_);
    spent_ += samples;
    const double percent =
        std::min(99.0, 100 * static_cast<double>(spent_) / std::max(whole_, 1.0));
    told_ =
        std::max(told_, static_cast<std::uint64_t>(percent / 100 * static_cast<double>(pixels_)));
    listener_(told_, pixels_);
  }
  void end() {
    if (listener_) listener_(pixels_, pixels_);
  }

 private:
  const ProgressListener& listener_;
  std::mutex mutex_;
  std::uint64_t pixels_, spent_ = 0, told_ = 0;
  double whole_ = 0;
};

// Whether truncation takes nine tenths of a target or more, so that nothing is left to
// sampling.
inline bool takes_all(double truncation, double target) {
  return 10 * truncation > 9 * target;
}
// What the target leaves to sampling. Squares add, where pixels are counted the errors do.
inline ErrorTarget left_to_sampling(ErrorTarget target, double truncation) {
  const double whole = target.error;
  // Nothing would be left: the picture cannot be that good, but its samples can.
  if (takes_all(truncation, whole)) return target;
  target.error =
      target.share > 0 ? whole - truncation : square_root(whole * whole - truncation * truncation);
  return target;
}

inline AccuracyReport report_of(const ErrorTarget& target, const Truncation& truncation,
                                const ErrorControl& control, bool in_time) {
  AccuracyReport report;
  report.target = target;
  report.max_depth = truncation.max_depth;
  report.cutoff = truncation.cutoff;
  report.truncation = truncation.error;
  report.confidence = kErrorConfidence;
  const double cut = target.share > 0 ? 0 : truncation.error;
  const auto whole = [&](double sampling) { return square_root(sampling * sampling + cut * cut); };
  report.estimate = whole(control.estimate().value);
  report.bound = whole(control.estimate().bound);
  if (takes_all(truncation.error, target.error)) {
    report.end = AccuracyEnd::out_of_depth;
  } else if (!control.reached()) {
    report.end = in_time ? AccuracyEnd::out_of_samples : AccuracyEnd::out_of_time;
  }
  return report;
}

template <class Real>
Result<RenderOutput> render_to_target(const RenderJob& whole) {
  const auto started = Deadline::Clock::now();
  const Deadline deadline(started, whole.options.time_limit);
  const RenderSettings& settings = whole.scene.settings;
  const ErrorTarget target = *settings.max_error;
  const int threads = thread_count(whole.options.threads);
  RenderOutput output;
  output.plan = whole.plan;
  AovRequest planes = whole.options.aovs;
  planes.error = true;
  make_planes(whole.window, planes, output.picture);
  World<Real> world(whole.scene, whole.images, threads);
  const TileJob<Real> job{world, output.plan, settings, whole.scene.camera, whole.options};
  const int size = whole.options.limits.tile_size;
  const auto tiles = tiles_of(
      whole.window, size > 0 ? size : tile_size(whole.window, static_cast<std::size_t>(threads)));
  Crew<Real> crew(job, std::min(threads, static_cast<int>(tiles.size())));
  const Error stopped{ErrorCode::stopped, "stopped before it was done"};

  TruncationLadder<Real> ladder(target, whole.window, settings.seed);
  const auto truncation = ladder.climb(output.plan, world, crew);
  if (!truncation) return stopped;
  ErrorControl control(left_to_sampling(target, truncation->error), whole.window.width,
                       whole.window.height, settings.seed);
  std::vector<typename TileRenderer<Real>::Kept> kept(tiles.size());
  PassProgress progress(whole.progress, whole.window);
  int passes = 0;
  bool in_time = true;
  while (control.has_next() && in_time) {
    progress.begin_pass(control.samples_ahead());
    const Deadline until = control.is_known() ? deadline : Deadline();
    in_time = crew.for_all(tiles.size(), [&](auto& renderer, std::size_t i) {
      const std::uint64_t before = renderer.samples();
      const bool done = renderer.add_samples(tiles[i], until, whole.window, control, kept[i]);
      progress.add(renderer.samples() - before);
      return done;
    });
    if (whole.options.cancel != nullptr && whole.options.cancel->load()) return stopped;
    control.plan_next();
    ++passes;
  }
  crew.for_all(tiles.size(), [&](auto& renderer, std::size_t i) {
    renderer.finish(kept[i], output.picture);
    return true;
  });
  for (std::size_t p = 0; p < output.picture.error.size(); ++p)
    output.picture.error[p] = static_cast<float>(control.standard_error(p));
  output.accuracy = report_of(target, *truncation, control, in_time);
  output.accuracy->passes = passes;
  for (const auto& worker : crew.workers())
    add_figures(worker->renderer, output.plan, worker->cpu_seconds, worker->elapsed_seconds,
                output.statistics);
  progress.end();
  output.statistics.threads = crew.size();
  output.statistics.wall_seconds =
      std::chrono::duration<double>(Deadline::Clock::now() - started).count();
  return output;
}

template <class Real>
Result<RenderOutput> render_in_one_type(const RenderJob& job) {
  return job.scene.settings.max_error ? render_to_target<Real>(job) : render_scene<Real>(job);
}

}  // namespace alhazen::render
