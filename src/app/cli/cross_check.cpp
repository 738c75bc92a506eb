// app/cli: alhazen cross-check: both programs, both pictures, one verdict for each scene.
#include "app/povray/cross_check.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "app/cli/cross_check_options.h"
#include "app/cli/interrupt.h"
#include "app/cli/overwrite_check.h"
#include "app/cli/scene_files.h"
#include "app/cli/scene_with_images.h"
#include "app/cli/streams.h"
#include "app/povray/allowances.h"
#include "app/povray/report_page.h"
#include "app/povray/temporary_folder.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxAllowancesBytes = std::uint64_t{1} << 24;

// Where the files go: the folder asked for, or one that is gone afterwards.
class WorkFolder {
 public:
  static Result<WorkFolder> make(const std::string& asked) {
    if (asked.empty()) {
      auto made = TemporaryFolder::make();
      if (!made) return made.error();
      fs::path path = made.value().path();
      return WorkFolder(std::move(path), std::move(made).value());
    }
    std::error_code failed;
    fs::create_directories(asked, failed);
    if (failed) {
      return Error{ErrorCode::io,
                   fmt::format("cannot make the folder `{}`: {}", asked, failed.message())};
    }
    return WorkFolder(asked, std::nullopt);
  }
  const fs::path& path() const { return path_; }

 private:
  WorkFolder(fs::path path, std::optional<TemporaryFolder> temporary)
      : path_(std::move(path)), temporary_(std::move(temporary)) {}

  fs::path path_;
  std::optional<TemporaryFolder> temporary_;
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
      outcomes_.push_back(
          {name_of(path, {}), Error{ErrorCode::scene, "the scene is wrong or cannot be read"}});
      return std::nullopt;
    }
    const auto inputs = files_used(input.loaded.evaluation, options.color_file);
    std::string name = name_of(path, input.scene());
    CheckedScene checked{std::move(name),      std::move(input.scene()),
                         input.loaded.sources, input.images,
                         by_hand(path),        std::nullopt};
    if (const Status apart = check_apart(checked, inputs); !apart) return report(apart.error());
    if (const Status good = find_allowance(path, checked); !good) return report(good.error());
    PovRunOptions run;
    run.program = request_.povray;
    run.threads = request_.threads;
    run.time_limit_seconds = request_.time_limit_seconds;
    run.cancel = &interrupted();
    CheckOutcome outcome{checked.name, cross_check(checked, folder_.path(), run)};
    if (!outcome.check) {
      const Error& error = outcome.check.error();
      if (interrupted()) return report({ErrorCode::stopped, "stopped by a signal"});
      if (error.code == ErrorCode::unsupported) return report(error);
      worst_ = std::max(worst_, report(error));
    } else {
      say(outcome.check.value());
    }
    outcomes_.push_back(std::move(outcome));
    return std::nullopt;
  }

  // A name whose files are of no other scene: folders may have scenes of one name, and a scene may
  // be called as the picture of another.
  std::string name_of(const std::string& path, const Scene& scene) {
    const std::string stem = fs::path(path).stem().string();
    for (int number = 1;; ++number) {
      std::string name = number == 1 ? stem : fmt::format("{}-{}", stem, number);
      const auto files = cross_check_files(scene, name);
      const auto is_taken = [this](const std::string& file) { return taken_.contains(file); };
      if (std::ranges::any_of(files, is_taken)) continue;
      taken_.insert(files.begin(), files.end());
      return name;
    }
  }

  // What is read is not written over: the report may be asked for in a folder of scenes.
  Status check_apart(const CheckedScene& checked, std::vector<fs::path> inputs) const {
    if (checked.by_hand) inputs.push_back(*checked.by_hand);
    std::vector<std::string> outputs;
    for (const std::string& file : cross_check_files(checked.scene, checked.name))
      outputs.push_back((folder_.path() / file).string());
    return check_overwrites(outputs, inputs);
  }

  std::optional<fs::path> by_hand(const std::string& path) const {
    if (request_.exported_only) return std::nullopt;
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
      if (Status known = check_names(parsed.value(), file); !known) return known;
      allowances_.emplace(file, std::move(parsed).value());
    }
    const Allowances& all = allowances_.at(file);
    const auto found = all.find(fs::path(path).filename().string());
    if (found != all.end()) checked.allowance = found->second;
    return Unit{};
  }

  // A misspelt name would leave its scene without its tolerance, or hide that the scene is gone.
  static Status check_names(const Allowances& allowances, const fs::path& file) {
    std::error_code ignored;
    for (const auto& [scene, allowance] : allowances) {
      if (fs::exists(file.parent_path() / scene, ignored)) continue;
      return Error{ErrorCode::usage,
                   fmt::format("{}: there is no scene `{}` beside it", file.string(), scene)};
    }
    return Unit{};
  }

  void say(const CrossCheck& check) const {
    if (request_.json) return;
    for (const Witness& w : check.witnesses) {
      write_stderr(fmt::format("{:<20} {} ({}): {}; {:.1f} ms, POV-Ray {:.1f} ms\n",
                               result_name(w.verdict), check.name, w.name, w.verdict.sentence,
                               1000 * check.our_seconds, 1000 * w.run.wall_seconds));
    }
    if (check.passes()) return;
    for (const std::string& deviation : check.deviation_texts)
      write_stderr(fmt::format("  note: {}\n", deviation));
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
    std::string sum = fmt::format("{} of {} scenes are the same", compared - different, compared);
    if (compared < outcomes_.size()) {
      sum += fmt::format("; {} could not be compared", outcomes_.size() - compared);
    }
    write_stderr(sum + "\n");
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
  std::set<std::string> taken_;  // names of files
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
