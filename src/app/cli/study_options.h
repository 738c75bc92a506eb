// app/cli: what `alhazen study` was asked for.
#pragma once

#include "app/cli/render_request.h"
#include "app/cli/scene_options.h"

namespace alhazen {

struct StudyRequest {
  std::vector<std::string> scenes;
  SceneOptions common;  // of every scene, but for its name
  std::string folder;
  std::optional<PictureSize> size;
  std::optional<double> budget;  // seconds, of all scenes together
  int threads = 1, runs = 3;
  std::optional<render::Isa> isa;
  bool with_povray = false;
  std::string povray = "povray";
  ProgressStyle progress = ProgressStyle::automatic;
  bool json = false;
};

// A code means that the verb is over.
std::optional<ExitCode> read_study_options(const Arguments& arguments, StudyRequest& request);

}  // namespace alhazen
