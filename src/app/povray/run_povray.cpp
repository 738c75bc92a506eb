#include "app/povray/run_povray.h"

#include <cstdlib>
#include <fmt/format.h>
#include <system_error>

#include "app/povray/child_process.h"
#include "app/povray/temporary_folder.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxSceneBytes = std::uint64_t{1} << 28;
constexpr std::uint64_t kMaxLogBytes = std::uint64_t{1} << 26;
constexpr std::uint64_t kMaxPictureBytes = std::uint64_t{1} << 36;
constexpr std::size_t kShownLogLines = 12;
// Where the packages of systems put what scenes include.
constexpr const char* kIncludeFolders[] = {"/usr/share/povray-3.7/include",
                                           "/usr/local/share/povray-3.7/include"};

// POV-Ray takes words apart at blanks, semicolons and quotes, does not open names beyond ASCII, and
// as installed writes in few folders only. So it works in one of ours, on a copy.
struct Workplace {
  TemporaryFolder folder;
  fs::path scene, picture, log, settings;

  explicit Workplace(TemporaryFolder made)
      : folder(std::move(made)),
        scene(folder.path() / "scene.pov"),
        picture(folder.path() / "picture.exr"),
        log(folder.path() / "log"),
        settings(folder.path() / "povray.ini") {}
};

// Instead of the person's own settings, and instead of a povray.ini beside the scene: either could
// make it another picture.
std::string settings_text() {
  std::string text;
  for (const char* folder : kIncludeFolders) {
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) text += fmt::format("Library_Path=\"{}\"\n", folder);
  }
  return text;
}

// A file name as one word: between quotes of the kind that is not in it.
std::string quoted(const fs::path& file) {
  const char quote = file.string().find('"') == std::string::npos ? '"' : '\'';
  return quote + file.string() + quote;
}

// +FE EXR, -D no window, -V no progress, -A and -J one ray through the pixel's centre.
std::vector<std::string> command_line(const Workplace& place, const PovRunOptions& options) {
  std::vector<std::string> words = {options.program,
                                    "+I" + quoted(place.scene),
                                    "+O" + quoted(place.picture),
                                    "+FE",
                                    fmt::format("+W{}", options.width),
                                    fmt::format("+H{}", options.height),
                                    fmt::format("+WT{}", options.threads),
                                    "-D",
                                    "-V",
                                    "-A",
                                    "-J"};
  words.insert(words.end(), options.more.begin(), options.more.end());
  return words;
}

Status copy_file(const fs::path& from, const fs::path& to, std::uint64_t max_bytes) {
  const auto bytes = read_file(from, max_bytes);
  if (!bytes) return bytes.error();
  return write_file_atomic(to, bytes.value());
}

// The last lines of the log: that is where POV-Ray says what is wrong. A scene can make it say
// anything, so what a terminal would obey is left out.
std::string end_of(const std::string& log) {
  std::size_t begin = log.size(), lines = 0;
  while (begin > 0 && (lines += log[begin - 1] == '\n' ? 1 : 0) <= kShownLogLines)
    --begin;
  std::string out = log.substr(begin);
  std::erase_if(out, [](unsigned char c) { return c != '\n' && (c < ' ' || c == 0x7f); });
  return out;
}

struct TraceTime {
  double elapsed = 0, cpu = 0;
};

// The number that stands after `mark`, which has to come before the next `stop`; 0 if none.
double seconds_after(const std::string& log, std::size_t begin, std::string_view mark,
                     std::string_view stop) {
  const std::size_t at = begin == std::string::npos ? begin : log.find(mark, begin);
  if (at == std::string::npos || at > log.find(stop, begin)) return 0;
  const double seconds = std::strtod(log.c_str() + at + mark.size(), nullptr);
  return seconds >= 0 && seconds < 1e9 ? seconds : 0;
}

// Of the last lines like
//   Trace Time:       0 hours  0 minutes  1 seconds (1.234 seconds)
//               using 2 thread(s) with 2.345 CPU-seconds total
TraceTime trace_time(const std::string& log) {
  const std::size_t line = log.rfind("Trace Time:");
  return {seconds_after(log, line, "(", "\n"), seconds_after(log, line, "with ", "CPU-seconds")};
}

Error refusal(const fs::path& scene, const ChildEnd& ended, const std::string& log) {
  const std::string why = ended.signal != 0 ? fmt::format("signal {}", ended.signal)
                                            : fmt::format("exit code {}", ended.exit_code);
  return {ErrorCode::usage,
          fmt::format("POV-Ray could not render `{}` ({}):\n{}", scene.string(), why, end_of(log))};
}

}  // namespace

Result<PovRun> run_povray(const fs::path& scene, const fs::path& picture,
                          const PovRunOptions& options) {
  auto made = TemporaryFolder::make();
  if (!made) return made.error();
  const Workplace place(std::move(made).value());
  for (const Status& done : {copy_file(scene, place.scene, kMaxSceneBytes),
                             write_file_atomic(place.settings, settings_text())}) {
    if (!done) return done.error();
  }
  ChildProcess process;
  process.words = command_line(place, options);
  process.folder = fs::absolute(scene).parent_path();  // where its pictures are
  process.log = place.log;
  process.environment = {"POVINI=" + place.settings.string()};
  process.max_log_bytes = kMaxLogBytes;
  process.time_limit_seconds = options.time_limit_seconds;
  process.cancel = options.cancel;
  const Result<ChildEnd> ended = run_child(process);
  if (!ended && ended.error().code == ErrorCode::unsupported) {
    return Error{ErrorCode::unsupported, "POV-Ray is needed, and " + ended.error().message +
                                             "; on Debian: apt install povray"};
  }
  if (!ended) return ended.error();
  const Result<std::string> log = read_file(place.log, 2 * kMaxLogBytes);
  if (!log) return log.error();
  const ChildEnd& end = ended.value();
  if (end.exit_code != 0 || end.signal != 0) return refusal(scene, end, log.value());
  std::error_code ignored;
  if (!fs::exists(place.picture, ignored)) {
    return Error{ErrorCode::io, fmt::format("POV-Ray wrote no picture of `{}`", scene.string())};
  }
  const Status kept = copy_file(place.picture, picture, kMaxPictureBytes);
  if (!kept) return kept.error();
  const TraceTime traced = trace_time(log.value());
  return PovRun{end.wall_seconds, end.cpu_seconds, traced.elapsed, traced.cpu, log.value()};
}

}  // namespace alhazen
