// app/cli: alhazen cross-check: both programs, both pictures, one verdict for each scene.
#include "app/povray/cross_check.h"

#include <cstdlib>
#include <fmt/format.h>
#include <map>
#include <system_error>

#include "app/cli/cross_check_options.h"
#include "app/cli/interrupt.h"
#include "app/cli/scene_with_images.h"
#include "app/cli/streams.h"
#include "app/povray/allowances.h"
#include "app/povray/report_page.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxAllowancesBytes = std::uint64_t{1} << 24;

// Where the files go: the folder asked for, or one that is gone afterwards.
class WorkFolder {
 public:
  static Result<WorkFolder> make(const std::string& asked) {
    std::error_code failed;
    if (!asked.empty()) {
      fs::create_directories(asked, failed);
      if (failed) {
        return Error{ErrorCode::io,
                     fmt::format("cannot make the folder `{}`: {}", asked, failed.message())};
      }
      return WorkFolder(asked, false);
    }
    std::string name = (fs::temp_directory_path(failed) / "alhazen-XXXXXX").string();
    if (failed || mkdtemp(name.data()) == nullptr) {
      return Error{ErrorCode::io, "cannot make a temporary folder"};
    }
    return WorkFolder(name, true);
  }
  WorkFolder(WorkFolder&& other) noexcept
      : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, false)) {}
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    if (temporary_) fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  WorkFolder(fs::path path, bool temporary) : path_(std::move(path)), temporary_(temporary) {}
  fs::path path_;
  bool temporary_;
};

class CrossCheckRun {
 public:
  CrossCheckRun(const CrossCheckRequest& request, const render::ColorConfig& colors,
                const WorkFolder& folder)
      : request_(request), colors_(colors), folder_(folder) {}

  ExitCode run() {
    for (const std::string& scene : request_.scenes) {
      if (const auto over = check(scene)) return *over;
    }
    return finish();
  }

 private:
  // A code when there is no point in going on: stopped, no POV-Ray, a broken file of tolerances.
  std::optional<ExitCode> check(const std::string& path) {
    SceneOptions options = request_.common;
    options.scene = path;
    SceneWithImages input;
    if (const auto code = load_with_images(options, colors_, request_.size, input)) {
      worst_ = std::max(worst_, *code);
      outcomes_.push_back({name_of(path), Error{ErrorCode::scene, "the scene is wrong"}});
      return std::nullopt;
    }
    CheckedScene checked{name_of(path),        std::move(input.scene()),
                         input.loaded.sources, input.images,
                         by_hand(path),        std::nullopt};
    if (const Status good = find_allowance(path, checked); !good) return report(good.error());
    PovRunOptions run;
    run.program = request_.povray;
    run.threads = request_.threads;
    run.time_limit_seconds = request_.time_limit_seconds;
    run.cancel = &interrupted();
    CheckOutcome outcome{checked.name, cross_check(checked, folder_.path(), run)};
    if (!outcome.check) {
      const Error& error = outcome.check.error();
      if (interrupted()) return ExitCode::stopped;
      if (error.code == ErrorCode::unsupported) return report(error);
      worst_ = std::max(worst_, report(error));
    } else {
      say(outcome.check.value());
    }
    outcomes_.push_back(std::move(outcome));
    return std::nullopt;
  }

  // Scenes of one name in two folders must not share their files.
  std::string name_of(const std::string& path) {
    const std::string stem = fs::path(path).stem().string();
    const int before = names_[stem]++;
    return before == 0 ? stem : fmt::format("{}-{}", stem, before + 1);
  }

  static std::optional<fs::path> by_hand(const std::string& path) {
    const fs::path file = fs::path(path).replace_extension(".pov");
    std::error_code ignored;
    return fs::exists(file, ignored) ? std::optional(file) : std::nullopt;
  }

  Status find_allowance(const std::string& path, CheckedScene& checked) {
    const fs::path beside = fs::path(path).parent_path() / "expected.json";
    const fs::path file = request_.allowances.empty() ? beside : fs::path(request_.allowances);
    std::error_code ignored;
    if (request_.allowances.empty() && !fs::exists(file, ignored)) return Unit{};
    if (!allowances_.contains(file)) {
      const auto text = read_file(file, kMaxAllowancesBytes);
      if (!text) return text.error();
      auto parsed = parse_allowances(text.value(), file.string());
      if (!parsed) return parsed.error();
      allowances_.emplace(file, std::move(parsed).value());
    }
    const Allowances& all = allowances_.at(file);
    const auto found = all.find(fs::path(path).filename().string());
    if (found != all.end()) checked.allowance = found->second;
    return Unit{};
  }

  void say(const CrossCheck& check) const {
    if (request_.json) return;
    for (const Witness& w : check.witnesses) {
      write_stderr(fmt::format("{:<20} {} ({}): {}; {:.1f} ms, POV-Ray {:.1f} ms\n",
                               result_name(w.verdict), check.name, w.name, w.verdict.sentence,
                               1000 * check.our_seconds, 1000 * w.run.wall_seconds));
    }
  }

  ExitCode finish() {
    const std::string json = report_json(outcomes_);
    if (!request_.report_folder.empty()) {
      if (const Status written = write_report(json); !written) return report(written.error());
    }
    if (request_.json) {
      if (const ExitCode printed = print(json); printed != ExitCode::done) return printed;
    }
    std::size_t different = 0, compared = 0;
    for (const CheckOutcome& outcome : outcomes_) {
      compared += outcome.check ? 1 : 0;
      different += outcome.check && !outcome.check.value().passes() ? 1 : 0;
    }
    write_stderr(
        fmt::format("{} of {} scenes are the same\n", compared - different, outcomes_.size()));
    if (worst_ != ExitCode::done) return worst_;
    return different > 0 ? ExitCode::different : ExitCode::done;
  }

  Status write_report(const std::string& json) const {
    const auto view = colors_.display_transform("", "");
    if (!view) return view.error();
    const Result<std::string> page = report_page(outcomes_, view.value());
    if (!page) return page.error();
    const FileWriting writing;
    const fs::path file = folder_.path() / "index.html";
    if (Status written = write_file_atomic(file, page.value()); !written) return written;
    if (Status written = write_file_atomic(folder_.path() / "results.json", json); !written) {
      return written;
    }
    write_stderr(fmt::format("report: {}\n", file.string()));
    return Unit{};
  }

  const CrossCheckRequest& request_;
  const render::ColorConfig& colors_;
  const WorkFolder& folder_;
  std::map<fs::path, Allowances> allowances_;
  std::map<std::string, int> names_;
  std::vector<CheckOutcome> outcomes_;
  ExitCode worst_ = ExitCode::done;
};

}  // namespace

ExitCode run_cross_check(const Arguments& arguments) {
  CrossCheckRequest request;
  if (const auto code = read_cross_check_options(arguments, request)) return *code;
  catch_interrupts();
  const auto colors = render::ColorConfig::open(render::color_source(request.common.color_file));
  if (!colors) return report(colors.error());
  const auto folder = WorkFolder::make(request.report_folder);
  if (!folder) return report(folder.error());
  return CrossCheckRun(request, colors.value(), folder.value()).run();
}

}  // namespace alhazen
