// app/povray: POV-Ray as a process: redirected, timed, stopped when it takes too long.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace alhazen {

struct PovRunOptions {
  int width = 0, height = 0;
  int threads = 1;
  std::string program = "povray";  // a name to be found on the path, or a path
  std::vector<std::string> more;   // further words for its command line
  double time_limit_seconds = 600;
  const std::atomic<bool>* cancel = nullptr;
};

struct PovRun {
  double wall_seconds = 0, cpu_seconds = 0;  // of the whole process
  double trace_seconds = 0;                  // of tracing alone, as it says itself
  double trace_cpu_seconds = 0;              // the same of all its threads
  std::string log;                           // all it wrote
};

// Renders `scene` to `picture`, an EXR file, without anti-aliasing: one ray through each pixel's
// centre. Paths are absolute or as from here; what the scene reads is found from its own folder.
// Whatever settings of POV-Ray lie about do not matter. Errors: unsupported when there is no such
// program; usage when POV-Ray refuses the scene, with the end of its log; limit when it was too
// slow; stopped; io. Then `picture` is as it was before.
Result<PovRun> run_povray(const std::filesystem::path& scene, const std::filesystem::path& picture,
                          const PovRunOptions& options);

}  // namespace alhazen
