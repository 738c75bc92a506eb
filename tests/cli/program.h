// tests/cli: the built program, run as a person or a farm runs it.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace alhazen::cli_test {

struct Outcome {
  int code;    // of the exit, or -1 after a signal
  int signal;  // that ended it, or 0
  std::string out, err;
};

// stdin is empty.
struct RunOptions {
  std::filesystem::path folder{};  // to run in; empty: the current one
  std::string stdout_path{};       // where stdout goes instead of Outcome::out
  // Sends this signal as soon as stderr holds `signal_after`; 0: none.
  int send_signal = 0;
  std::string signal_after{};
};

Outcome run_alhazen(const std::vector<std::string>& words, const RunOptions& options = {});

// A fresh folder for each test, gone after it.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  Outcome run(const std::vector<std::string>& words) const { return run_alhazen(words, {folder_}); }
  std::string path(const std::string& name) const { return folder_ / name; }
  // Writes the file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  // The names in the folder, hidden ones included, sorted.
  std::vector<std::string> entries() const;

  std::filesystem::path folder_;
};

// A scene that renders in an instant and uses a bit of everything that has a stage of its own.
extern const char* const kSmallScene;

}  // namespace alhazen::cli_test
