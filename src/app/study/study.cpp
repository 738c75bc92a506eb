#include "app/study/study.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "app/study/measure.h"
#include "app/study/number_text.h"
#include "app/study/povray_sweep.h"
#include "app/study/truncation_ladder.h"
#include "core/base/parallel.h"
#include "render/film/filter.h"
#include "render/wave/plan.h"

namespace alhazen {
namespace {

constexpr int kPilotSamples = 4;
constexpr int kFewestReferenceSamples = 64, kMostReferenceSamples = 1 << 20;
constexpr int kFewestFilterReferenceSamples = 256;
// Of the time for references: the rest is shared by the other filters'.
constexpr double kMainReferenceShare = 0.7;

int power_of_two_below(double value) {
  return 1 << static_cast<int>(std::floor(std::log2(std::clamp(value, 1.0, 1e9))));
}

class SceneStudying {
 public:
  SceneStudying(const StudyInput& input, const StudyOptions& options, const StudyListener& listen)
      : input_(input),
        options_(options),
        listen_(listen),
        run_{input.scene, input.images, options.threads, options.isa, options.cancel},
        shares_(time_shares(options.with_povray)) {}

  Result<SceneStudy> run() {
    describe_scene();
    for (const auto step :
         {&SceneStudying::pilot, &SceneStudying::find_truncation, &SceneStudying::make_reference,
          &SceneStudying::choose, &SceneStudying::make_filter_references, &SceneStudying::sweep,
          &SceneStudying::study_rounding, &SceneStudying::ask_povray}) {
      if (const Status done = (this->*step)(); !done) return done.error();
    }
    study_.seconds = elapsed();
    return std::move(study_);
  }

 private:
  // Time is counted as a machine that does nothing else would take it.
  double elapsed() const {
    const double timed = process_cpu_seconds() - started_ - converging_cpu_seconds_;
    return timed / options_.threads + converging_cpu_seconds_ / converging_threads() +
           povray_seconds_;
  }
  // The converged pictures are not timed: they take all cores.
  static int converging_threads() { return thread_count(0); }
  double seconds_of(const TimedRender& render) const {
    return render.cpu_seconds / options_.threads;
  }
  void say(const std::string& step) const {
    if (listen_) listen_(step, std::min(0.999, elapsed() / std::max(expected_, elapsed())));
  }

  void describe_scene() {
    study_.name = input_.name;
    study_.width = input_.scene.settings.width;
    study_.height = input_.scene.settings.height;
    study_.own_width = input_.own_width;
    study_.own_height = input_.own_height;
    study_.threads = options_.threads;
    study_.runs = options_.runs;
    study_.budget = expected_ = options_.seconds;
    effects_ = render::effects_of(input_.scene);
    plan_ = plan_sweep(input_.scene, effects_);
    study_.left_out = plan_.left_out;
  }

  // The scene's settings with a fixed number of samples.
  StudySetting fixed(int samples) const {
    StudySetting setting;
    setting.settings = input_.scene.settings;
    setting.settings.adaptive.reset();
    setting.settings.max_error.reset();
    setting.settings.samples = samples;
    return setting;
  }

  Status pilot() {
    say("measuring what a sample costs");
    const auto warm = timed_render(run_, fixed(kPilotSamples / 2));
    if (!warm) return warm.error();
    const auto few = timed_render(run_, fixed(kPilotSamples / 2));
    if (!few) return few.error();
    const auto more = timed_render(run_, fixed(2 * kPilotSamples));
    if (!more) return more.error();
    const double steps = 2 * kPilotSamples - kPilotSamples / 2;
    const render::RenderStatistics& s = more.value().statistics;
    study_.isa = s.isa;
    cost_.seconds_a_sample =
        std::max(1e-6, (seconds_of(more.value()) - seconds_of(few.value())) / steps);
    cost_.fixed_seconds =
        std::max(0.0, seconds_of(few.value()) - kPilotSamples / 2 * cost_.seconds_a_sample);
    cost_.scene_light_samples = most_light_samples(input_.scene);
    if (effects_.has(Effect::soft_shadows)) {
      cost_.shadow_share = static_cast<double>(s.shadow_rays) / static_cast<double>(s.rays());
    }
    return Unit{};
  }

  Status find_truncation() {
    const RenderSettings& own = input_.scene.settings;
    truncation_.rung = {own.max_depth, own.cutoff};
    truncation_.seconds = cost_.fixed_seconds + kPilotSamples * cost_.seconds_a_sample;
    if (!is_called_for(Knob::depth, effects_)) return Unit{};
    say("finding a depth and a cutoff for the reference");
    const TruncationRung first{std::max(32, own.max_depth), std::min(1.0 / 1024, own.cutoff)};
    LadderLimits limits;
    limits.max_seconds = options_.seconds * shares_.references * kPilotSamples / 512;
    const auto render_rung = [this](const TruncationRung& rung) -> Result<RungPicture> {
      const auto made = timed_render(run_, at_rung(fixed(kPilotSamples), rung));
      if (!made) return made.error();
      return RungPicture{made.value().picture, seconds_of(made.value())};
    };
    auto found = climb(first, limits, render_rung);
    if (!found) return found.error();
    truncation_ = found.value();
    return Unit{};
  }

  static StudySetting at_rung(StudySetting setting, const TruncationRung& rung) {
    setting.settings.max_depth = rung.max_depth;
    setting.settings.cutoff = rung.cutoff;
    return setting;
  }

  // How many of the reference's depth and cutoff fit into the time; a power of two.
  int reference_samples(double seconds) const {
    const double a_sample = truncation_.seconds * options_.threads / kPilotSamples;
    return power_of_two_below(seconds * converging_threads() / std::max(a_sample, 1e-7));
  }

  Result<Reference> reference_of(const ReconstructionFilter& filter, double seconds) {
    const int half = std::clamp(reference_samples(seconds) / 2, kFewestReferenceSamples / 2,
                                kMostReferenceSamples / 2);
    RenderRun converging = run_;
    converging.threads = converging_threads();
    StudySetting setting = at_rung(fixed(half), truncation_.rung);
    setting.settings.filter = filter;
    RgbPicture halves[2];
    for (int k = 0; k < 2; ++k) {
      say(fmt::format("the converged picture, {}, {} samples, half {} of 2",
                      setting_name(filter.kind), half, k + 1));
      setting.settings.seed = half_seed(input_.scene.settings.seed, k);
      auto made = timed_render(converging, setting);
      if (!made) return made.error();
      converging_cpu_seconds_ += made.value().cpu_seconds;
      halves[k] = std::move(made.value().picture);
    }
    Reference reference{mean_of(halves[0], halves[1]), setting.settings,
                        error_of_mean(halves[0], halves[1]), truncation_.error};
    reference.settings.samples = 2 * half;
    return reference;
  }

  Status make_reference() {
    const ReconstructionFilter& filter = input_.scene.settings.filter;
    auto made = reference_of(filter, options_.seconds * shares_.references * kMainReferenceShare);
    if (!made) return made.error();
    study_.reference = made.value().settings;
    study_.sampling_error = made.value().sampling_error;
    study_.truncation_error = made.value().truncation_error;
    references_.emplace(filter.kind, std::move(made).value());
    return Unit{};
  }

  void leave_out(const std::vector<LeftOut>& more) {
    study_.left_out.insert(study_.left_out.end(), more.begin(), more.end());
  }

  // Each of the three other filters needs a reference; one of fewer samples than this shows
  // nothing.
  void leave_out_filters_without_time() {
    const double seconds = options_.seconds * shares_.references * (1 - kMainReferenceShare) / 3;
    if (reference_samples(seconds) >= kFewestFilterReferenceSamples) return;
    const auto is_of_filter = [](const StudySetting& s) { return s.knob == Knob::filter; };
    std::erase_if(plan_.settings, is_of_filter);
    study_.left_out.push_back(
        {"filter", "the time does not suffice for a converged picture with each of them"});
  }

  Status choose() {
    leave_out_filters_without_time();
    BudgetChoice near = within_reference(plan_.settings, study_.reference.samples);
    leave_out(near.left_out);
    chosen_ = choose_for_budget(near.kept, cost_, options_.runs, options_.seconds * shares_.sweep);
    leave_out(chosen_.left_out);
    expected_ = elapsed() + chosen_.seconds +
                options_.seconds * ((1 - kMainReferenceShare) * shares_.references +
                                    shares_.rounding + shares_.povray);
    return Unit{};
  }

  Status make_filter_references() {
    std::vector<FilterKind> wanted;
    const auto want = [&](FilterKind kind) {
      if (!references_.contains(kind) && std::ranges::find(wanted, kind) == wanted.end()) {
        wanted.push_back(kind);
      }
    };
    if (options_.with_povray) want(FilterKind::box);
    for (const StudySetting& setting : chosen_.kept)
      want(setting.settings.filter.kind);
    const double seconds = options_.seconds * shares_.references * (1 - kMainReferenceShare) /
                           static_cast<double>(std::max<std::size_t>(1, wanted.size()));
    for (const FilterKind kind : wanted) {
      auto made = reference_of({kind, render::usual_radius(kind)}, seconds);
      if (!made) return made.error();
      study_.filter_references.push_back(
          {kind, made.value().settings.samples, made.value().own_error()});
      references_.emplace(kind, std::move(made).value());
    }
    return Unit{};
  }

  const Reference& main_reference() const {
    return references_.at(input_.scene.settings.filter.kind);
  }

  Status sweep() {
    const auto once = timed_render(run_, fixed(1));
    if (!once) return once.error();
    window_ = thumbnail_window(once.value().picture, main_reference().picture);
    std::optional<RgbPicture> untruncated;
    if (is_called_for(Knob::depth, effects_)) {
      auto made = timed_render(
          run_, at_rung(fixed(comparing_samples(input_.scene.settings)), truncation_.rung));
      if (!made) return made.error();
      untruncated = std::move(made.value().picture);
    }
    Measuring measuring{run_, references_, untruncated, window_, input_.look, input_.view};
    const double deadline = elapsed() + 1.5 * chosen_.seconds + 1;
    std::vector<Measured> measured = different_settings(chosen_.kept);
    for (int round = 0; round < options_.runs; ++round) {
      for (Measured& m : measured) {
        if (round > 0 && elapsed() > deadline) break;
        say(fmt::format("run {} of {}: {}", round + 1, options_.runs, describe(m.setting)));
        if (Status done = measuring.run(m); !done) return done;
      }
    }
    study_.points = points_of(chosen_.kept, measured);
    return Unit{};
  }

  Status study_rounding() {
    const double seconds = options_.seconds * shares_.rounding;
    int samples = 16;
    StudySetting setting = fixed(samples);
    setting.precision = render::Precision::quad;
    while (samples > 1 && predicted_seconds(setting, cost_) > seconds)
      setting.settings.samples = samples /= 2;
    if (predicted_seconds(setting, cost_) > 3 * seconds) {
      study_.left_out.push_back(
          {"rounding error",
           "a picture in quad takes about " + duration_text(predicted_seconds(setting, cost_))});
      return Unit{};
    }
    say(fmt::format("in quad, {} samples", samples));
    auto rounding = measure_rounding(run_, setting, options_.runs, input_.look);
    if (!rounding && rounding.error().code == ErrorCode::unsupported) {
      study_.left_out.push_back({"rounding error", rounding.error().message});
      return Unit{};
    }
    if (!rounding) return rounding.error();
    study_.rounding = std::move(rounding).value();
    return Unit{};
  }

  Status ask_povray() {
    if (!options_.with_povray) return Unit{};
    const double seconds = options_.seconds * shares_.povray;
    expected_ = elapsed() + seconds;
    const auto listen = [this, seconds](const std::string& step, double share) {
      povray_seconds_ = share * seconds;
      say(step);
    };
    auto swept =
        sweep_povray(input_, options_, references_.at(FilterKind::box), window_, seconds, listen);
    if (!swept) return swept.error();
    povray_seconds_ = swept.value().seconds;
    study_.povray = std::move(swept.value().study);
    for (StudyPoint& point : swept.value().points)
      study_.points.push_back(std::move(point));
    return Unit{};
  }

  const StudyInput& input_;
  const StudyOptions& options_;
  const StudyListener& listen_;
  RenderRun run_;
  TimeShares shares_;
  EffectSet effects_;
  SweepPlan plan_;
  PilotCost cost_;
  Truncation truncation_;
  std::map<FilterKind, Reference> references_;
  BudgetChoice chosen_;
  ThumbnailWindow window_;
  SceneStudy study_;
  double expected_ = 0;
  double povray_seconds_ = 0, converging_cpu_seconds_ = 0;
  double started_ = process_cpu_seconds();
};

}  // namespace

std::optional<double> RoundingStudy::gain() const {
  double in_float = 0, in_double = 0;
  for (const RoundingPoint& point : points) {
    if (point.precision == render::Precision::float32) in_float = point.errors.rmse;
    if (point.precision == render::Precision::float64) in_double = point.errors.rmse;
  }
  if (!(in_double > 0)) return std::nullopt;
  return in_float / in_double;
}

const StudyPoint& SceneStudy::scene_point() const {
  const auto own = [](const StudyPoint& point) { return point.setting.is_scene; };
  return *std::ranges::find_if(points, own);
}

double SceneStudy::floor() const {
  return kReferenceMargin * std::hypot(sampling_error, truncation_error);
}

Result<SceneStudy> study_scene(const StudyInput& input, const StudyOptions& options,
                               const StudyListener& listen) {
  return SceneStudying(input, options, listen).run();
}

}  // namespace alhazen
