#include "app/povray/run_povray.h"

#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <thread>
#include <unistd.h>

#include "core/base/file.h"
#include "render/image/exr_read.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const char* const kScene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    "camera { location 0 direction z right x up y }\nbackground { rgb <0.25, 0.5, 1> }\n";

// Finds the word that begins with +O, without its quotes.
const char* const kFindOutput =
    "for w in \"$@\"; do case $w in +O*) out=${w#+O}; out=${out#?}; out=${out%?};; esac; done\n";

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

// A folder with a scene in it, and one below for temporary files, to see that they go.
class RunPovray : public testing::Test {
 protected:
  RunPovray() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::temp_directory_path() / fmt::format("alhazen_povray_{}_{}", test->name(), ::getpid());
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "tmp");
    if (const char* given = std::getenv("TMPDIR")) tmpdir_ = given;
    ::setenv("TMPDIR", (folder_ / "tmp").c_str(), 1);
    write("s.pov", kScene);
    options_.width = 8;
    options_.height = 6;
  }
  ~RunPovray() override {
    EXPECT_EQ(names_in(folder_ / "tmp"), std::vector<std::string>{}) << "left behind";
    if (tmpdir_.empty()) {
      ::unsetenv("TMPDIR");
    } else {
      ::setenv("TMPDIR", tmpdir_.c_str(), 1);
    }
    fs::remove_all(folder_);
  }

  fs::path write(const fs::path& name, const std::string& text) const {
    EXPECT_TRUE(write_file_atomic(folder_ / name, text));
    return folder_ / name;
  }
  std::string read(const fs::path& name) const {
    const auto bytes = read_file(folder_ / name, 1 << 20);
    return bytes ? bytes.value() : "";
  }
  // A program that does what the shell script says.
  void fake(const std::string& script) {
    const fs::path program = write("fake", "#!/bin/sh\n" + script);
    fs::permissions(program, fs::perms::owner_all);
    options_.program = program;
  }
  Result<PovRun> run(const fs::path& scene = "s.pov") const {
    return run_povray(folder_ / scene, folder_ / "out.exr", options_);
  }
  Error error_of(const Result<PovRun>& ran) const {
    EXPECT_FALSE(ran);
    EXPECT_FALSE(fs::exists(folder_ / "out.exr"));
    return ran ? Error{} : ran.error();
  }

  fs::path folder_;
  std::string tmpdir_;
  PovRunOptions options_;
};

TEST_F(RunPovray, AMissingProgramIsNamedWithWhatToInstall) {
  for (const char* const program : {"/nonexistent/povray", "no-such-povray", "./povray", ""}) {
    options_.program = program;
    const Error error = error_of(run());
    EXPECT_EQ(error.code, ErrorCode::unsupported) << program;
    EXPECT_THAT(error.message, HasSubstr(fmt::format("no program `{}`", program)));
    EXPECT_THAT(error.message, HasSubstr("apt install povray"));
  }
}

TEST_F(RunPovray, AProgramThatCannotBeStartedIsSaid) {
  options_.program = write("plain.txt", "no program");
  const Error error = error_of(run());
  EXPECT_EQ(error.code, ErrorCode::io);
  EXPECT_THAT(error.message, HasSubstr("plain.txt"));
}

TEST_F(RunPovray, AMissingSceneIsAnIoErrorBeforeAnythingStarts) {
  fake("touch '" + (folder_ / "started").string() + "'\n");
  const Error error = error_of(run("none.pov"));
  EXPECT_EQ(error.code, ErrorCode::io);
  EXPECT_THAT(error.message, HasSubstr("none.pov"));
  EXPECT_FALSE(fs::exists(folder_ / "started"));
}

TEST_F(RunPovray, ARefusalShowsTheEndOfTheLog) {
  fake(
      "i=0; while [ $i -lt 100 ]; do echo line $i; i=$((i+1)); done; echo 'Parse Error' >&2\nexit "
      "3");
  const Error error = error_of(run());
  EXPECT_EQ(error.code, ErrorCode::usage);
  EXPECT_THAT(error.message, HasSubstr("s.pov"));
  EXPECT_THAT(error.message, HasSubstr("exit code 3"));
  EXPECT_THAT(error.message, HasSubstr("line 99\nParse Error\n"));
  EXPECT_THAT(error.message, Not(HasSubstr("line 80\n")));
}

TEST_F(RunPovray, TheLogCannotCommandATerminal) {
  fake("printf 'bad\\033[2J\\007\\rword\\n'; exit 1");
  EXPECT_THAT(error_of(run()).message, HasSubstr("bad[2Jword\n"));
}

TEST_F(RunPovray, ASignalIsNamed) {
  fake("kill -SEGV $$");
  const Error error = error_of(run());
  EXPECT_EQ(error.code, ErrorCode::usage);
  EXPECT_THAT(error.message, HasSubstr(fmt::format("signal {}", SIGSEGV)));
}

bool is_alive(const std::string& process) {
  // A zombie answers to signals, too: its parent here is init, which may take its time.
  std::ifstream stat("/proc/" + process + "/stat");
  std::string number, name, state;
  return stat >> number >> name >> state && state != "Z" && state != "X";
}

void expect_dead(const std::string& process) {
  ASSERT_FALSE(process.empty());
  for (int i = 0; i < 200 && is_alive(process); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(is_alive(process));
}

// Writes the numbers of itself and of a child, and waits for long.
constexpr const char* kSleeper = "sleep 300 & echo $! > '{0}/child'; echo $$ > '{0}/self'; wait\n";

TEST_F(RunPovray, TooSlowIsKilledWithItsChildren) {
  fake(fmt::format(fmt::runtime(kSleeper), folder_.string()));
  options_.time_limit_seconds = 0.5;
  const Error error = error_of(run());
  EXPECT_EQ(error.code, ErrorCode::limit);
  EXPECT_THAT(error.message, HasSubstr("more than 0.5 seconds"));
  std::string self = read("self"), child = read("child");
  expect_dead(self.substr(0, self.find('\n')));
  expect_dead(child.substr(0, child.find('\n')));
}

TEST_F(RunPovray, CancelledIsKilledWithItsChildren) {
  fake(fmt::format(fmt::runtime(kSleeper), folder_.string()));
  std::atomic<bool> cancel = false;
  options_.cancel = &cancel;
  std::thread person([&] {
    while (read("self").empty())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    cancel = true;
  });
  const Error error = error_of(run());
  person.join();
  EXPECT_EQ(error.code, ErrorCode::stopped);
  std::string self = read("self"), child = read("child");
  expect_dead(self.substr(0, self.find('\n')));
  expect_dead(child.substr(0, child.find('\n')));
}

TEST_F(RunPovray, EndlessMessagesAreALimit) {
  fake("exec yes 'a line that fills the disk, again and again and again and again and again'");
  const Error error = error_of(run());
  EXPECT_EQ(error.code, ErrorCode::limit);
  EXPECT_THAT(error.message, HasSubstr("of messages"));
}

TEST_F(RunPovray, TheTimeOfTracingIsRead) {
  const auto traced = [&](const std::string& line) {
    fake(std::string(kFindOutput) + "echo x > \"$out\"; cat <<'E'\n" + line + "\nE\n");
    const auto ran = run();
    EXPECT_TRUE(ran) << (ran ? "" : ran.error().message);
    return ran ? ran.value().trace_seconds : -1;
  };
  EXPECT_EQ(traced("  Trace Time:       0 hours  0 minutes  0 seconds (0.123 seconds)"), 0.123);
  EXPECT_EQ(traced("  Trace Time:       1 hours  0 minutes  1 seconds (3601.5 seconds)\n  more"),
            3601.5);
  EXPECT_EQ(traced("nothing"), 0);
  EXPECT_EQ(traced("Trace Time: none"), 0);
  EXPECT_EQ(traced("Trace Time:\n(7 seconds)"), 0);
  EXPECT_EQ(traced("Trace Time: (what)"), 0);
  EXPECT_EQ(traced("Trace Time: (-1) (nan)"), 0);
  EXPECT_EQ(traced("Trace Time: " + std::string(1'000'000, 'x')), 0);
}

TEST_F(RunPovray, TimesAreMeasuredAndTheLogIsKept) {
  fake(std::string(kFindOutput) + "echo hello; echo picture > \"$out\"; sleep 0.2\n");
  const auto ran = run();
  ASSERT_TRUE(ran);
  EXPECT_GE(ran.value().wall_seconds, 0.2);
  EXPECT_GE(ran.value().cpu_seconds, 0);
  EXPECT_LT(ran.value().cpu_seconds, 0.2);
  EXPECT_EQ(ran.value().log, "hello\n");
  EXPECT_EQ(read("out.exr"), "picture\n");
  EXPECT_EQ(names_in(folder_), (std::vector<std::string>{"fake", "out.exr", "s.pov", "tmp"}));
}

TEST_F(RunPovray, WhatWasThereBeforeIsNoPictureOfThisRun) {
  fake("exit 0");
  write("out.exr", "old");
  const auto ran = run();
  ASSERT_FALSE(ran);
  EXPECT_EQ(ran.error().code, ErrorCode::io);
  EXPECT_THAT(ran.error().message, HasSubstr("wrote no picture"));
}

TEST_F(RunPovray, RunsInTheFolderOfTheSceneWithItsOwnSettings) {
  fs::create_directories(folder_ / "below");
  write("below/s.pov", kScene);
  fake(std::string(kFindOutput) +
       "pwd; echo \"ini=$POVINI\"; test -f \"$POVINI\" && echo there\n"
       "echo x > \"$out\"\n");
  const auto ran = run("below/s.pov");
  ASSERT_TRUE(ran);
  EXPECT_THAT(ran.value().log, HasSubstr(fs::canonical(folder_ / "below").string() + "\n"));
  EXPECT_THAT(ran.value().log, HasSubstr("ini=" + (folder_ / "tmp").string()));
  EXPECT_THAT(ran.value().log, HasSubstr("there\n"));
}

TEST_F(RunPovray, PathsFromHereWork) {
  fake(std::string(kFindOutput) + "pwd; echo x > \"$out\"\n");
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  options_.program = "./fake";
  const auto ran = run_povray("s.pov", "out.exr", options_);
  fs::create_directories("below");
  write("below/s.pov", kScene);
  const auto from_below = run_povray("below/s.pov", "out.exr", options_);
  fs::current_path(before);
  EXPECT_TRUE(ran) << ran.error().message;
  EXPECT_TRUE(from_below) << from_below.error().message;
}

TEST_F(RunPovray, SignalsReachTheChildAsUsual) {
  sigset_t blocked, old;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &blocked, &old);
  fake("kill -TERM $$; exit 0");
  const Error error = error_of(run());
  pthread_sigmask(SIG_SETMASK, &old, nullptr);
  EXPECT_THAT(error.message, HasSubstr(fmt::format("signal {}", SIGTERM)));
}

TEST_F(RunPovray, NoPlaceForTemporaryFilesIsSaid) {
  ::setenv("TMPDIR", (folder_ / "none").c_str(), 1);
  const Error error = error_of(run());
  ::setenv("TMPDIR", (folder_ / "tmp").c_str(), 1);
  EXPECT_EQ(error.code, ErrorCode::io);
  EXPECT_THAT(error.message, HasSubstr("TMPDIR"));
}

// The real one.
class RealPovray : public RunPovray {
 protected:
  void SetUp() override {
    if (std::system("command -v povray > /dev/null") != 0) {
      GTEST_SKIP() << "POV-Ray is not installed: nothing of this test ran (apt install povray)";
    }
  }
  void expect_rendered(const fs::path& scene, const fs::path& picture) const {
    const auto ran = run_povray(scene, picture, options_);
    ASSERT_TRUE(ran) << scene << ran.error().message;
    const auto parts = render::read_exr(picture);
    ASSERT_TRUE(parts) << picture;
    const auto& pixels = parts.value().front().pixels;
    EXPECT_EQ(pixels.width(), 8);
    EXPECT_EQ(pixels.height(), 6);
    EXPECT_EQ(pixels.at(*pixels.find("G"), 0, 0), 0.5F) << scene;
    EXPECT_EQ(pixels.at(*pixels.find("G"), 7, 5), 0.5F) << scene;
  }
};

TEST_F(RealPovray, TakesAnyName) {
  for (const char* const name : {"a b", "-x", "+K5", "+W3", "a;b", "a'b", "a\"b", "a\\b",
                                 "\u00fc\u2028", "a%s", "#c", "x=1", "Width=3", "a\nb", "\xff"}) {
    fs::create_directories(folder_ / name);
    const fs::path file = fs::path(name) / (std::string(name) + ".pov");
    write(file, kScene);
    expect_rendered(folder_ / file, folder_ / name / (std::string(name) + ".exr"));
  }
}

TEST_F(RealPovray, FindsWhatTheSceneReads) {
  fs::create_directories(folder_ / "a b");
  write("a b/own.inc", "background { rgb 0.5 }\n");
  write("a b/s.pov", std::string(kScene) + "#include \"own.inc\"\n");
  expect_rendered(folder_ / "a b/s.pov", folder_ / "out.exr");
}

// Start_Row alone would leave the upper half black.
TEST_F(RealPovray, SettingsBesideTheSceneDoNotMatter) {
  write("povray.ini", "Start_Row=4\nOutput_Alpha=on\nWidth=3\n");
  ::setenv("POVINI", (folder_ / "povray.ini").c_str(), 1);
  expect_rendered(folder_ / "s.pov", folder_ / "out.exr");
  ::unsetenv("POVINI");
  expect_rendered(folder_ / "s.pov", folder_ / "out.exr");
}

TEST_F(RealPovray, ReportsWhatItRefuses) {
  write("s.pov", std::string(kScene) + "sphere { 0, }\n");
  write("out.exr", "old");
  const auto ran = run();
  ASSERT_FALSE(ran);
  EXPECT_EQ(ran.error().code, ErrorCode::usage);
  EXPECT_THAT(ran.error().message, HasSubstr("line 5"));
  EXPECT_EQ(read("out.exr"), "old");
}

}  // namespace
}  // namespace alhazen
