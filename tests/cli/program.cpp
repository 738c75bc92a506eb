#include "cli/program.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/file.h"

namespace alhazen::cli_test {
namespace {

struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) std::abort();
    read_end = ends[0];
    write_end = ends[1];
  }
};

// Both streams at once, so that neither can fill up while the other is waited for.
void drain(int out, int err, pid_t child, const RunOptions& options, Outcome& outcome) {
  std::array<pollfd, 2> streams = {{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  std::array<std::string*, 2> texts = {&outcome.out, &outcome.err};
  bool signal_sent = options.send_signal == 0;
  for (int open = 2; open > 0;) {
    ::poll(streams.data(), streams.size(), -1);
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].revents == 0) continue;
      std::array<char, 1 << 16> chunk{};
      const ssize_t count = ::read(streams[i].fd, chunk.data(), chunk.size());
      if (count > 0) {
        texts[i]->append(chunk.data(), static_cast<std::size_t>(count));
        continue;
      }
      ::close(streams[i].fd);
      streams[i].fd = -1;
      --open;
    }
    if (!signal_sent && outcome.err.find(options.signal_after) != std::string::npos) {
      ::kill(child, options.send_signal);
      signal_sent = true;
    }
  }
}

}  // namespace

Outcome run_alhazen(const std::vector<std::string>& words, const RunOptions& options) {
  std::string program = ALHAZEN_PROGRAM;
  std::vector<std::string> owned = words;
  std::vector<char*> arguments = {program.data()};
  for (std::string& word : owned)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);

  const Pipe out, err;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, out.write_end, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, err.write_end, STDERR_FILENO);
  if (!options.stdout_path.empty()) {
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, options.stdout_path.c_str(),
                                       O_WRONLY, 0);
  }
  if (!options.folder.empty()) {
    ::posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  }
  pid_t child = 0;
  Outcome outcome{-1, 0, {}, {}};
  const int failure =
      ::posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), ::environ);
  ::posix_spawn_file_actions_destroy(&actions);
  for (const int end : {out.write_end, err.write_end})
    ::close(end);
  if (failure != 0) {
    ADD_FAILURE() << "cannot start " << program;
    return outcome;
  }
  drain(out.read_end, err.read_end, child, options, outcome);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  return outcome;
}

ProgramTest::ProgramTest() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = std::filesystem::temp_directory_path() /
            (std::string("alhazen_cli_") + test->test_suite_name() + "_" + test->name() + "_" +
             std::to_string(::getpid()));
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
}

ProgramTest::~ProgramTest() {
  std::filesystem::remove_all(folder_);
}

std::string ProgramTest::write(const std::string& name, const std::string& text) const {
  EXPECT_TRUE(write_file_atomic(folder_ / name, text));
  return folder_ / name;
}

std::string ProgramTest::read(const std::string& name) const {
  const Result<std::string> bytes = read_file(folder_ / name, 1 << 28);
  EXPECT_TRUE(bytes) << name;
  return bytes ? bytes.value() : "";
}

std::vector<std::string> ProgramTest::entries() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  return names;
}

const char* const kSmallScene = R"(#scn 1
param frame = 0
param ball_ior = 1.5 in 1 .. 3 "index of refraction"

render { size <48, 32>  samples 4 }
camera perspective { position <0, 1.5, -6>  look_at <0, 1, 0>  fov 40deg }
light point { position <5, 8, -5>  intensity rgb(60) }
plane { normal y  material diffuse { color checker(rgb(0.9), rgb(0.1)) } }
sphere { center <0.1 * frame, 1, 0>  radius 1  material glass { ior ball_ior } }
sphere { center <-2, 0.5, 1>  radius 0.5  material mirror { color rgb(0.9) } }
)";

}  // namespace alhazen::cli_test
