#include "app/povray/run_povray.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <regex>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>

#include "core/base/file.h"

extern char** environ;

namespace alhazen {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMaxLogBytes = std::uint64_t{1} << 26;
constexpr std::size_t kShownLogLines = 12;
constexpr auto kPollInterval = std::chrono::milliseconds(1);

// +FE EXR, -D no window, -V no progress, -A and -J one ray through the pixel's centre.
std::vector<std::string> command_line(const fs::path& scene, const fs::path& picture,
                                      const PovRunOptions& options) {
  std::vector<std::string> words = {options.program,
                                    "+I" + scene.filename().string(),
                                    "+O" + fs::absolute(picture).string(),
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

// Starts it in the scene's folder, where its pictures are, with all output in `log`.
Result<pid_t> start(const std::vector<std::string>& words, const fs::path& folder,
                    const fs::path& log) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == ENOENT) {
    return Error{ErrorCode::unsupported,
                 fmt::format("POV-Ray is needed, and there is no program `{}`; on Debian: apt "
                             "install povray",
                             words[0])};
  }
  if (failed != 0) {
    return Error{ErrorCode::io, fmt::format("cannot start `{}`: {}", words[0],
                                            std::generic_category().message(failed))};
  }
  return child;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

struct Ended {
  int status = 0;
  double cpu_seconds = 0;
};

Result<Ended> wait_for(pid_t child, const PovRunOptions& options) {
  const auto limit = Clock::now() + std::chrono::duration<double>(options.time_limit_seconds);
  for (;;) {
    rusage used{};
    Ended ended;
    const pid_t done = wait4(child, &ended.status, WNOHANG, &used);
    if (done == child) {
      ended.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
      return ended;
    }
    const bool cancelled = options.cancel != nullptr && options.cancel->load();
    if (cancelled || Clock::now() > limit) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
      if (cancelled) return Error{ErrorCode::stopped, "stopped while POV-Ray was running"};
      return Error{ErrorCode::limit,
                   fmt::format("POV-Ray took more than {} seconds", options.time_limit_seconds)};
    }
    std::this_thread::sleep_for(kPollInterval);
  }
}

// The last lines of the log: that is where POV-Ray says what is wrong.
std::string end_of(const std::string& log) {
  std::size_t begin = log.size(), lines = 0;
  while (begin > 0 && lines <= kShownLogLines) {
    --begin;
    if (log[begin] == '\n') ++lines;
  }
  return log.substr(begin);
}

double trace_seconds(const std::string& log) {
  static const std::regex kTrace(R"(Trace Time:[^(]*\(([0-9.]+) seconds\))");
  std::smatch match;
  return std::regex_search(log, match, kTrace) ? std::strtod(match[1].str().c_str(), nullptr) : 0;
}

}  // namespace

Result<PovRun> run_povray(const fs::path& scene, const fs::path& picture,
                          const PovRunOptions& options) {
  const fs::path log_file = fs::absolute(picture).string() + ".log";
  const fs::path folder = fs::absolute(scene).parent_path();
  const auto started = Clock::now();
  const Result<pid_t> child = start(command_line(scene, picture, options), folder, log_file);
  if (!child) return child.error();
  const Result<Ended> ended = wait_for(child.value(), options);
  PovRun run;
  run.wall_seconds = std::chrono::duration<double>(Clock::now() - started).count();
  const Result<std::string> log = read_file(log_file, kMaxLogBytes);
  std::error_code ignored;
  fs::remove(log_file, ignored);
  if (!ended) return ended.error();
  if (!log) return log.error();
  run.log = log.value();
  run.cpu_seconds = ended.value().cpu_seconds;
  run.trace_seconds = trace_seconds(run.log);
  const int status = ended.value().status;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return Error{ErrorCode::usage, fmt::format("POV-Ray could not render `{}`:\n{}", scene.string(),
                                               end_of(run.log))};
  }
  return run;
}

}  // namespace alhazen
