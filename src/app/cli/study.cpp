// app/cli: alhazen study: scenes to pages that show what accuracy costs.
#include "app/study/study.h"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "app/cli/interrupt.h"
#include "app/cli/overwrite_check.h"
#include "app/cli/progress.h"
#include "app/cli/scene_files.h"
#include "app/cli/scene_with_images.h"
#include "app/cli/streams.h"
#include "app/cli/study_options.h"
#include "app/study/number_text.h"
#include "app/study/report_data.h"
#include "app/study/report_page.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

constexpr double kSecondsAScene = 120;
constexpr int kUsualWidth = 160;
constexpr const char* kIndexName = "index";

Status make_folder(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!failed) return Unit{};
  return Error{ErrorCode::io,
               fmt::format("cannot make the folder `{}`: {}", folder, failed.message())};
}

// Small pictures: there will be many. What is asked for is taken as it is.
PictureSize study_size(const RenderSettings& settings, const std::optional<PictureSize>& asked) {
  if (asked) return *asked;
  if (settings.width <= kUsualWidth) return {settings.width, settings.height};
  const double scale = static_cast<double>(kUsualWidth) / settings.width;
  return {kUsualWidth, std::max(1, static_cast<int>(scale * settings.height + 0.5))};
}

// Shares of the whole, as progress; the meter counts in ten thousandths.
class StudyProgress {
 public:
  StudyProgress(ProgressStyle style, FramePosition position)
      : meter_(style == ProgressStyle::automatic
                   ? (stderr_is_terminal() ? ProgressStyle::bar : ProgressStyle::plain)
                   : style,
               std::move(position), stderr_columns()) {}

  void show(double share) {
    constexpr std::uint64_t kWhole = 10'000;
    most_ = std::max(most_, share);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    write_stderr(meter_.update(static_cast<std::uint64_t>(most_ * kWhole), kWhole, spent.count()));
  }
  void clear() { write_stderr(meter_.clear()); }

 private:
  ProgressMeter meter_;
  double most_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class StudyRunner {
 public:
  StudyRunner(const StudyRequest& request, const render::ColorConfig& colors)
      : request_(request), colors_(colors) {}

  ExitCode run() {
    for (std::size_t i = 0; i < request_.scenes.size(); ++i) {
      if (const auto code = study(i)) return *code;
    }
    return finish();
  }

 private:
  // What is left of the time, shared among the scenes that are left.
  double seconds_for(std::size_t index) const {
    if (!request_.budget) return kSecondsAScene;
    double left = *request_.budget;
    for (const SceneStudy& study : studies_)
      left -= study.seconds;
    return std::max(1.0, left / static_cast<double>(request_.scenes.size() - index));
  }

  // A code when there is no point in going on.
  std::optional<ExitCode> study(std::size_t index) {
    const std::string& path = request_.scenes[index];
    SceneOptions options = request_.common;
    options.scene = path;
    SceneWithImages input;
    if (const auto code = load_with_images(options, colors_, std::nullopt, input)) return code;
    Scene& scene = input.scene();
    const PictureSize own{scene.settings.width, scene.settings.height};
    const PictureSize size = study_size(scene.settings, request_.size);
    scene.settings.width = size.width;
    scene.settings.height = size.height;
    scene.settings.transparent_background = false;  // errors are of light alone
    const std::string name = name_of(path);
    const auto inputs = files_used(input.loaded.evaluation, request_.common.color_file);
    if (const Status apart = check_overwrites(files_of(name), inputs); !apart) {
      return report(apart.error());
    }
    const auto view = colors_.display_transform("", "");
    if (!view) return report(view.error());
    DisplayLook look;
    if (const auto space = colors_.working_chromaticities()) look.rec709 = rec709_from(*space);
    const StudyInput studied{name, scene,        input.images, input.loaded.sources,
                             look, view.value(), own.width,    own.height};
    const double seconds = seconds_for(index);
    if (request_.progress != ProgressStyle::none) {
      write_stderr(fmt::format("{}: {} x {} pixels, about {}\n", name, size.width, size.height,
                               duration_text(seconds)));
    }
    StudyProgress progress(request_.progress, {name, index, request_.scenes.size()});
    auto result = study_scene(studied, study_options(seconds),
                              [&](const std::string&, double share) { progress.show(share); });
    progress.clear();
    if (!result && interrupted()) {
      return report({ErrorCode::stopped, "stopped by a signal; pages that were finished stay"});
    }
    if (!result) return report(result.error());
    if (const Status written = write(name, result.value()); !written)
      return report(written.error());
    if (!request_.json) {
      if (const ExitCode shown = print(study_table(result.value()) + "\n");
          shown != ExitCode::done) {
        return shown;
      }
    }
    studies_.push_back(std::move(result).value());
    return std::nullopt;
  }

  StudyOptions study_options(double seconds) const {
    StudyOptions options;
    options.seconds = seconds;
    options.threads = request_.threads;
    options.isa = request_.isa;
    options.runs = request_.runs;
    options.with_povray = request_.with_povray;
    options.povray = request_.povray;
    options.cancel = &interrupted();
    return options;
  }

  // Folders may have scenes of one name, and one may be called as the index is.
  std::string name_of(const std::string& path) {
    const std::string stem = fs::path(path).stem().string();
    for (int number = 1;; ++number) {
      std::string name = number == 1 ? stem : fmt::format("{}-{}", stem, number);
      if (name != kIndexName && taken_.insert(name).second) return name;
    }
  }

  std::string in_folder(const std::string& file) const {
    return (fs::path(request_.folder) / file).string();
  }
  std::vector<std::string> files_of(const std::string& name) const {
    std::vector<std::string> files;
    for (const char* const ending : {".html", ".csv", ".json"})
      files.push_back(in_folder(name + ending));
    if (request_.scenes.size() > 1) files.push_back(in_folder(std::string(kIndexName) + ".html"));
    return files;
  }

  Status write(const std::string& name, const SceneStudy& study) const {
    const Result<std::string> page = study_page(study);
    if (!page) return page.error();
    const std::string texts[] = {page.value(), study_csv(study), study_json(study).dump(1) + "\n"};
    const FileWriting writing;
    const std::vector<std::string> files = files_of(name);
    for (std::size_t i = 0; i < std::size(texts); ++i) {
      if (Status written = write_file_atomic(files[i], texts[i]); !written) return written;
    }
    write_stderr(fmt::format("page: {}\n", files[0]));
    return Unit{};
  }

  ExitCode finish() const {
    if (studies_.size() > 1) {
      if (const Status written = write_index(); !written) return report(written.error());
    }
    if (!request_.json) return ExitCode::done;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const SceneStudy& study : studies_)
      all.push_back(study_json(study));
    return print((studies_.size() == 1 ? all[0] : all).dump(1) + "\n");
  }

  Status write_index() const {
    std::vector<IndexEntry> entries;
    for (const SceneStudy& study : studies_)
      entries.push_back({study, study.name + ".html"});
    const Result<std::string> page = study_index(entries);
    if (!page) return page.error();
    const std::string file = in_folder(std::string(kIndexName) + ".html");
    const FileWriting writing;
    if (Status written = write_file_atomic(file, page.value()); !written) return written;
    write_stderr(fmt::format("index: {}\n", file));
    return Unit{};
  }

  const StudyRequest& request_;
  const render::ColorConfig& colors_;
  std::set<std::string> taken_;
  std::vector<SceneStudy> studies_;
};

}  // namespace

ExitCode run_study(const Arguments& arguments) {
  StudyRequest request;
  if (const auto code = read_study_options(arguments, request)) return *code;
  catch_interrupts();
  const auto colors = render::ColorConfig::open(render::color_source(request.common.color_file));
  if (!colors) return report(colors.error());
  if (const Status made = make_folder(request.folder); !made) return report(made.error());
  return StudyRunner(request, colors.value()).run();
}

}  // namespace alhazen
