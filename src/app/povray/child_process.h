// app/povray: another program, run to its end or to ours.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace alhazen {

struct ChildProcess {
  // The program and its words. A program with a slash in it is a path as from here; without, it is
  // looked for where programs are.
  std::vector<std::string> words;
  std::filesystem::path folder;          // to run in
  std::filesystem::path log;             // where all it says goes
  std::vector<std::string> environment;  // NAME=VALUE, beside or instead of ours
  std::uint64_t max_log_bytes = std::uint64_t{1} << 26;
  double time_limit_seconds = 600;
  const std::atomic<bool>* cancel = nullptr;
};

struct ChildEnd {
  int exit_code = 0;
  int signal = 0;  // that ended it, or 0
  double wall_seconds = 0, cpu_seconds = 0;
};

// Runs it without input. When it takes too long, says too much or is cancelled, it is killed
// together with all it has started. Errors: unsupported when there is no such program; limit;
// stopped; io when it cannot be started.
Result<ChildEnd> run_child(const ChildProcess& process);

}  // namespace alhazen
