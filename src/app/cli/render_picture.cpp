#include "app/cli/render_picture.h"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>

#include "app/cli/accuracy_text.h"
#include "app/cli/exr_output.h"
#include "app/cli/interrupt.h"
#include "app/cli/load_images.h"
#include "app/cli/load_scene.h"
#include "app/cli/overrides.h"
#include "app/cli/overwrite_check.h"
#include "app/cli/provenance.h"
#include "app/cli/scene_files.h"
#include "app/cli/streams.h"
#include "core/base/file.h"
#include "render/color/preview.h"
#include "render/image/png_write.h"

namespace alhazen {
namespace {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Error stopped_error() {
  return {ErrorCode::stopped, "stopped by a signal; the picture was not written"};
}

ExitCode report_failure(const Error& error) {
  const ExitCode code = report(error);
  return interrupted() ? ExitCode::stopped : code;
}

// Better to hear of it now than after the last ray.
Status check_writable(const std::string& path) {
  if (path.empty() || path == "-") return Unit{};
  const Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  return Unit{};
}

ProgressStyle progress_style(ProgressStyle asked) {
  if (asked != ProgressStyle::automatic) return asked;
  return stderr_is_terminal() ? ProgressStyle::bar : ProgressStyle::plain;
}

Result<render::RenderOutput> render_with_progress(const RenderRequest& request,
                                                  const PictureJob& job, const Scene& scene,
                                                  const LoadedImages& images) {
  render::RenderOptions options;
  options.precision = request.precision;
  if (request.crop) options.crop = *request.crop;
  options.threads = request.threads;
  options.isa = request.isa;
  options.aovs = request.aovs;
  options.time_limit = request.time_limit;
  options.cancel = &interrupted();
  ProgressMeter meter(progress_style(request.progress), job.position, stderr_columns());
  const Stopwatch watch;
  const auto show = [&](std::uint64_t done, std::uint64_t total) {
    write_stderr(meter.update(done, total, watch.seconds()));
  };
  Result<render::RenderOutput> output = render::render(scene, images.pixels, options, show);
  write_stderr(meter.clear());
  if (!output && interrupted()) return stopped_error();
  return output;
}

Status write_output(const std::string& path, const std::string& bytes, PictureReport& report) {
  const Status written = path == "-" ? write_stdout(bytes) : write_file_atomic(path, bytes);
  if (written) report.files.push_back({path, bytes.size()});
  return written;
}

// The picture as `view` shows it, over black where it is transparent.
Result<std::string> encode_preview(const render::FloatBuffer& beauty,
                                   const render::ColorTransform& view) {
  const auto rgb8 =
      render::preview_rgb8(view, beauty.channel(0), beauty.channel(1), beauty.channel(2));
  return render::encode_png(rgb8, beauty.width(), beauty.height(), 3);
}

Status write_files(const RenderRequest& request, const PictureJob& job,
                   const render::ColorConfig& colors, const render::ExrFile& file,
                   PictureReport& report) {
  const Stopwatch watch;
  Result<render::EncodedExr> exr = render::encode_exr(file, report.rendering.threads);
  if (!exr) return exr.error();
  std::string preview;
  if (!job.preview.empty()) {
    const auto view = colors.display_transform(request.display, request.view);
    if (!view) return view.error();
    Result<std::string> png = encode_preview(file.beauty, view.value());
    if (!png) return png.error();
    preview = std::move(png).value();
  }
  const FileWriting writing;
  if (interrupted()) return stopped_error();
  if (Status written = write_output(job.output, exr.value().bytes, report); !written)
    return written;
  if (!job.preview.empty()) {
    if (Status written = write_output(job.preview, preview, report); !written) return written;
  }
  report.samples = exr.value().report;
  report.write_seconds = watch.seconds();
  return Unit{};
}

// What says something only where an accuracy is asked for.
Status check_target(const RenderRequest& request, const RenderSettings& settings) {
  if (settings.max_error) return Unit{};
  const char* option = request.time_limit > 0 ? "--time-limit"
                       : request.aovs.error   ? "--aov error"
                                              : nullptr;
  if (option == nullptr) return Unit{};
  return Error{ErrorCode::usage,
               fmt::format("{} goes with --max-error, --preset or a scene with max_error", option)};
}

// Everything that can be found wrong before the first ray.
Status prepare(const RenderRequest& request, const PictureJob& job, parser::Evaluation& evaluation,
               PictureReport& report) {
  const std::vector<std::string> outputs = {job.output, job.preview, request.statistics};
  if (Status apart = check_overwrites(outputs, files_used(evaluation, request.color_file));
      !apart) {
    return apart;
  }
  Scene& scene = *evaluation.scene;
  if (Status good = apply_overrides(request.settings, scene.settings); !good) return good;
  const Result<render::PixelRect> window = picture_window(request, scene.settings);
  if (!window) return window.error();
  if (Status good = check_target(request, scene.settings); !good) return good;
  render::AovRequest planes = request.aovs;
  planes.error = scene.settings.max_error.has_value();
  if (Status fits = check_memory(window.value(), planes, physical_memory_bytes()); !fits) {
    return fits;
  }
  if (Status good = check_writable(job.output); !good) return good;
  if (Status good = check_writable(job.preview); !good) return good;
  if (Status good = check_writable(request.statistics); !good) return good;
  report.scene = request.scene;
  report.label = job.position.label;
  report.width = scene.settings.width;
  report.height = scene.settings.height;
  report.window = window.value();
  report.precision = request.precision;
  return Unit{};
}

bool is_there(const PictureJob& job, const Provenance& made_by) {
  return is_made_by(job.output, made_by) &&
         (job.preview.empty() || std::filesystem::exists(job.preview));
}

}  // namespace

ExitCode render_picture(const RenderRequest& request, const PictureJob& job,
                        const render::ColorConfig& colors, std::vector<PictureReport>& reports) {
  const Stopwatch watch;
  PictureReport report;
  std::vector<parser::Define> defines = request.defines;
  if (job.frame)
    defines.push_back({"frame", fmt::format("{}", *job.frame), parser::Define::Option::frames});
  const auto eval = eval_options(colors, defines, request.files);
  if (!eval) return alhazen::report(eval.error());
  LoadedScene loaded;
  if (const auto code = load_scene(request.scene, eval.value(), loaded)) return *code;
  if (const Status good = prepare(request, job, loaded.evaluation, report); !good) {
    return report_failure(good.error());
  }
  const Scene& scene = *loaded.evaluation.scene;

  DiagnosticSink image_errors;
  const LoadedImages images = load_images(scene, colors, image_errors);
  show_diagnostics(image_errors, loaded.sources);
  if (image_errors.error_count() > 0) return exit_code(image_errors.code());
  Provenance made_by = provenance(request, defines, scene, images.hash, colors);
  if (request.skip_existing && is_there(job, made_by)) {
    if (!request.quiet) write_stderr(fmt::format("{}: is there already, skipped\n", job.output));
    return ExitCode::done;
  }
  report.load_seconds = watch.seconds();

  const auto output = render_with_progress(request, job, scene, images);
  if (!output) return report_failure(output.error());
  report.rendering = output.value().statistics;
  report.accuracy = output.value().accuracy;
  if (report.accuracy) tell_accuracy(*report.accuracy, made_by);
  const render::ExrFile file = exr_file(scene, output.value().picture, request, colors, made_by);
  if (const Status written = write_files(request, job, colors, file, report); !written) {
    return report_failure(written.error());
  }
  report.peak_memory_bytes = peak_memory_bytes();
  if (!request.quiet) write_stderr(statistics_text(report));
  const auto accuracy = report.accuracy;
  reports.push_back(std::move(report));
  if (!accuracy || accuracy->end == render::AccuracyEnd::reached) return ExitCode::done;
  write_stderr(fmt::format("alhazen: {}\n", shortfall_text(*accuracy)));
  return exit_code(*accuracy);
}

}  // namespace alhazen
