#include "app/povray/child_process.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace alhazen {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kPollInterval = std::chrono::milliseconds(1);

std::string found_name(const std::string& program) {
  // The search for it is in the folder that the child runs in.
  return program.find('/') == std::string::npos ? program : fs::absolute(program).string();
}

std::vector<std::string> merged_environment(const std::vector<std::string>& more) {
  std::vector<std::string> all = more;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view given = *entry;
    bool replaced = false;
    for (const std::string& own : more)
      replaced |= given.starts_with(own.substr(0, own.find('=') + 1));
    if (!replaced) all.emplace_back(given);
  }
  return all;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> out;
  for (const std::string& word : words)
    out.push_back(const_cast<char*>(word.c_str()));
  out.push_back(nullptr);
  return out;
}

// A process group of its own, so that its children can be ended too; and the signals as a program
// expects to find them, which ours blocks and ignores.
class Attributes {
 public:
  Attributes() {
    sigset_t none, usual;
    sigemptyset(&none);
    sigemptyset(&usual);
    for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ})
      sigaddset(&usual, number);
    posix_spawnattr_init(&value_);
    posix_spawnattr_setflags(
        &value_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&value_, 0);
    posix_spawnattr_setsigmask(&value_, &none);
    posix_spawnattr_setsigdefault(&value_, &usual);
  }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  ~Attributes() { posix_spawnattr_destroy(&value_); }
  const posix_spawnattr_t* get() const { return &value_; }

 private:
  posix_spawnattr_t value_{};
};

Result<pid_t> start(const ChildProcess& process) {
  const std::vector<std::string> environment = merged_environment(process.environment);
  const std::string program = found_name(process.words.front());
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, process.log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, process.folder.c_str());
  const Attributes attributes;
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program.c_str(), &actions, attributes.get(),
                                  pointers(process.words).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed == 0) return child;
  if (failed == ENOENT) {
    return Error{ErrorCode::unsupported,
                 fmt::format("there is no program `{}`", process.words.front())};
  }
  return Error{ErrorCode::io, fmt::format("cannot start `{}`: {}", process.words.front(),
                                          std::generic_category().message(failed))};
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double seconds(Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

// Why it is to be ended, if it is.
Status may_go_on(const ChildProcess& process, Clock::time_point started) {
  const std::string& program = process.words.front();
  if (process.cancel != nullptr && process.cancel->load()) {
    return Error{ErrorCode::stopped, fmt::format("stopped while `{}` was running", program)};
  }
  if (seconds(Clock::now() - started) > process.time_limit_seconds) {
    return Error{ErrorCode::limit, fmt::format("`{}` took more than {} seconds", program,
                                               process.time_limit_seconds)};
  }
  std::error_code ignored;
  const auto said = fs::file_size(process.log, ignored);
  if (!ignored && said > process.max_log_bytes) {
    return Error{ErrorCode::limit, fmt::format("`{}` wrote more than {} bytes of messages", program,
                                               process.max_log_bytes)};
  }
  return Unit{};
}

}  // namespace

Result<ChildEnd> run_child(const ChildProcess& process) {
  const auto started = Clock::now();
  const Result<pid_t> child = start(process);
  if (!child) return child.error();
  for (;;) {
    rusage used{};
    int status = 0;
    const pid_t done = wait4(child.value(), &status, WNOHANG, &used);
    if (done == child.value()) {
      return ChildEnd{WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                      WIFSIGNALED(status) ? WTERMSIG(status) : 0, seconds(Clock::now() - started),
                      seconds(used.ru_utime) + seconds(used.ru_stime)};
    }
    if (done < 0 && errno != EINTR) {
      return Error{ErrorCode::io, fmt::format("cannot wait for `{}`: {}", process.words.front(),
                                              std::generic_category().message(errno))};
    }
    if (const Status good = may_go_on(process, started); !good) {
      killpg(child.value(), SIGKILL);
      waitpid(child.value(), nullptr, 0);
      return good.error();
    }
    std::this_thread::sleep_for(kPollInterval);
  }
}

}  // namespace alhazen
