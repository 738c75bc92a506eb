#include "app/study/povray_sweep.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/povray/export_pov.h"
#include "app/povray/povray_picture.h"
#include "app/povray/run_povray.h"
#include "app/povray/temporary_folder.h"
#include "core/base/file.h"
#include "core/scene/effect.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

struct Traced {
  RgbPicture picture;
  PovRun run;
};

RgbPicture rgb_of(const render::FloatBuffer& buffer) {
  RgbPicture picture{buffer.width(), buffer.height(), {}};
  picture.rgb.resize(3 * buffer.pixel_count());
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < buffer.pixel_count(); ++i)
      picture.rgb[3 * i + c] = buffer.channel(c)[i];
  }
  return picture;
}

// Each run begins with a pause, whatever there is to render.
constexpr double kStartSeconds = 0.5;

constexpr int kLensSamples = 256, kGridLevel = 3;  // of the first picture that could be a reference
constexpr int kFinestLevel = 3;
constexpr double kLevelCost = 4;

PovraySetting lens(int samples) {
  return {Knob::povray_lens, fmt::format("{}", samples), {}, samples};
}

PovraySetting method(int number, double threshold, int depth) {
  return {number == 1 ? Knob::povray_method_1 : Knob::povray_method_2,
          fmt::format("{:g} R{}", threshold, depth),
          {fmt::format("+A{:.4f}", threshold), fmt::format("+AM{}", number),
           fmt::format("+R{}", depth), "-J"},
          0};
}

// A cutoff or a depth that is not quite the same is a setting; everything else is another picture.
bool is_other_picture(const Deviation& deviation) {
  return deviation.kind != DeviationKind::cutoff && deviation.kind != DeviationKind::depth;
}

class PovraySweeping {
 public:
  PovraySweeping(const StudyInput& input, const StudyOptions& options, const Reference& converged,
                 const ThumbnailWindow& window, double seconds, const StudyListener& listen)
      : input_(input),
        options_(options),
        converged_(converged),
        window_(window),
        seconds_(seconds),
        listen_(listen),
        has_lens_(derive_effects(input.scene).has(Effect::depth_of_field)) {}

  Result<PovraySweep> run() {
    auto made = TemporaryFolder::make();
    if (!made) return made.error();
    folder_ = made.value().path();
    for (const auto step : {&PovraySweeping::make_reference, &PovraySweeping::sweep}) {
      const Status done = (this->*step)();
      if (done) continue;
      if (done.error().code == ErrorCode::stopped) return done.error();
      sweep_.study.failure = done.error().message;
      break;
    }
    return std::move(sweep_);
  }

 private:
  // Lens samples are a matter of the text, all else of the command line.
  Result<Traced> trace(const PovraySetting& setting) {
    Scene scene = input_.scene;
    scene.settings.filter = {};
    scene.settings.adaptive.reset();
    scene.settings.max_error.reset();
    if (setting.blur_samples > 0) scene.settings.samples = setting.blur_samples;
    const auto exported = export_pov(scene, input_.sources, input_.images, "scene");
    if (!exported) return exported.error();
    if (deviations_.empty()) deviations_ = exported.value().deviations;
    const fs::path text = folder_ / "scene.pov", picture = folder_ / "picture.exr";
    for (const PovFile& file : exported.value().files) {
      const Status written = write_file_atomic(folder_ / file.name, file.bytes);
      if (!written) return written.error();
    }
    const Status written = write_file_atomic(text, exported.value().text);
    if (!written) return written.error();
    PovRunOptions run;
    run.width = scene.settings.width;
    run.height = scene.settings.height;
    run.threads = options_.threads;
    run.program = options_.povray;
    run.more = setting.words;
    run.cancel = options_.cancel;
    auto ran = run_povray(text, picture, run);
    if (!ran) return ran.error();
    sweep_.seconds += kStartSeconds + ran.value().cpu_seconds / options_.threads;
    const auto read = read_povray_picture(picture, run.width, run.height);
    if (!read) return read.error();
    return Traced{rgb_of(read.value()), std::move(ran).value()};
  }

  // Ours serves where both programs say the same; otherwise POV-Ray is measured against itself.
  Status make_reference() {
    const auto first = trace(finest(0));
    if (!first) return first.error();
    PovrayStudy& study = sweep_.study;
    study.deviations = deviation_texts(deviations_, input_.sources);
    study.own_reference = std::ranges::any_of(deviations_, is_other_picture);
    if (study.own_reference) return refine(first.value());
    reference_ = converged_.picture;
    study.floor = converged_.floor();
    study.from_ours = rmse_of(first.value().picture, reference_);
    study.reference = "the same converged picture";
    return Unit{};
  }

  // The finest picture that half of the time suffices for, and what the one before says of it.
  Status refine(const Traced& first) {
    Traced before = first;
    double difference = 0;
    int level = 0;
    while (level < kFinestLevel &&
           (level == 0 || kLevelCost * before.run.cpu_seconds / options_.threads < seconds_ / 2)) {
      listen_("POV-Ray's converged picture", sweep_.seconds / seconds_);
      auto finer = trace(finest(++level));
      if (!finer) return finer.error();
      difference = rmse_of(finer.value().picture, before.picture);
      before = std::move(finer).value();
    }
    reference_ = before.picture;
    PovrayStudy& study = sweep_.study;
    const double own =
        has_lens_ ? error_of_more_samples(difference) : error_of_finer_grid(difference);
    study.floor = kReferenceMargin * own;
    study.from_ours = rmse_of(reference_, converged_.picture);
    study.reference =
        has_lens_
            ? fmt::format("its own picture with {} samples of the lens", kLensSamples << level)
            : fmt::format("its own picture with {0} \u00d7 {0} samples in every pixel",
                          1 << (kGridLevel + level));
    return Unit{};
  }

  // Twice as many samples, or as many on a side, with each level.
  PovraySetting finest(int level) const {
    return has_lens_ ? lens(kLensSamples << level) : method(2, 0, kGridLevel + level);
  }

  Status sweep() {
    const std::vector<PovraySetting> settings = povray_settings(has_lens_);
    std::vector<std::vector<double>> cpu(settings.size()), wall(settings.size());
    for (int round = 0; round < options_.runs; ++round) {
      for (std::size_t i = 0; i < settings.size(); ++i) {
        if (round > 0 && cpu[i].empty()) continue;
        if (sweep_.seconds > seconds_ && (round > 0 || i > 1)) continue;
        listen_(fmt::format("{} {}", info(settings[i].knob).title, settings[i].label),
                sweep_.seconds / seconds_);
        const auto traced = trace(settings[i]);
        if (!traced) return traced.error();
        cpu[i].push_back(traced.value().run.trace_cpu_seconds);
        wall[i].push_back(traced.value().run.trace_seconds);
        if (round == 0) add_point(settings[i], traced.value().picture);
      }
    }
    for (std::size_t i = 0; i < sweep_.points.size(); ++i) {
      StudyPoint& point = sweep_.points[i];
      point.runs = static_cast<int>(cpu[i].size());
      point.cpu = spread_of(cpu[i]);
      point.wall = spread_of(wall[i]);
    }
    return Unit{};
  }

  void add_point(const PovraySetting& setting, const RgbPicture& picture) {
    StudyPoint point;
    point.setting.knob = setting.knob;
    point.setting.label = setting.label;
    point.setting.settings = input_.scene.settings;
    point.errors = errors_of(picture, reference_, input_.look);
    point.floor = sweep_.study.floor;
    point.pictures = study_pictures(picture, reference_, window_, input_.view);
    sweep_.points.push_back(std::move(point));
  }

  const StudyInput& input_;
  const StudyOptions& options_;
  const Reference& converged_;
  ThumbnailWindow window_;
  double seconds_;
  const StudyListener& listen_;
  bool has_lens_;
  fs::path folder_;
  std::vector<Deviation> deviations_;
  RgbPicture reference_;
  PovraySweep sweep_;
};

}  // namespace

std::vector<PovraySetting> povray_settings(bool has_lens) {
  std::vector<PovraySetting> settings;
  if (has_lens) {
    for (const int samples : {4, 7, 19, 37, 64, 128, 256})
      settings.push_back(lens(samples));
    return settings;
  }
  settings.push_back({Knob::povray_method_1, "-A", {}, 0});
  // Far apart first: a short budget gives both curves their ends.
  const std::pair<double, int> kPairs[] = {{0.1, 3},  {0.003, 5}, {0.03, 4}, {0.3, 3},
                                           {0.01, 3}, {0.01, 4},  {0.3, 2},  {0, 3}};
  for (const auto& [threshold, depth] : kPairs) {
    settings.push_back(method(2, threshold, depth));
    settings.push_back(method(1, threshold, depth));
  }
  return settings;
}

double error_of_finer_grid(double difference) {
  return difference / (std::pow(2, 1.5) - 1);
}

double error_of_more_samples(double difference) {
  // Of independent pictures with errors e sqrt(2) and e.
  return difference / std::sqrt(3);
}

Result<PovraySweep> sweep_povray(const StudyInput& input, const StudyOptions& options,
                                 const Reference& converged, const ThumbnailWindow& window,
                                 double seconds, const StudyListener& listen) {
  return PovraySweeping(input, options, converged, window, seconds, listen).run();
}

}  // namespace alhazen
