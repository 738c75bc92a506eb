// app/cli: the exit codes that scripts rely on; docs/command_line.md tells them to people.
#pragma once

#include "core/base/result.h"

namespace alhazen {

enum class ExitCode {
  done = 0,
  scene_wrong = 1,
  usage = 2,
  io = 3,
  limit = 4,
  different = 5,  // two pictures that were compared
  stopped = 75,   // EX_TEMPFAIL of sysexits.h: run it again
};

constexpr ExitCode exit_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::scene:
      return ExitCode::scene_wrong;
    case ErrorCode::usage:
    case ErrorCode::unsupported:
      return ExitCode::usage;
    case ErrorCode::io:
      return ExitCode::io;
    case ErrorCode::limit:
      return ExitCode::limit;
    case ErrorCode::stopped:
      return ExitCode::stopped;
  }
  return ExitCode::usage;
}

}  // namespace alhazen
