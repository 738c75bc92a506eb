// app/cli: what `alhazen cross-check` was asked for.
#pragma once

#include "app/cli/render_request.h"
#include "app/cli/scene_options.h"

namespace alhazen {

struct CrossCheckRequest {
  std::vector<std::string> scenes;
  SceneOptions common;  // of every scene, but for its name
  std::string report_folder, allowances;
  std::string povray = "povray";
  std::optional<PictureSize> size;
  int threads = 1;
  double time_limit_seconds = 600;
  bool exported_only = false;
  bool json = false;
};

// A code means that the verb is over.
std::optional<ExitCode> read_cross_check_options(const Arguments& arguments,
                                                 CrossCheckRequest& request);

}  // namespace alhazen
