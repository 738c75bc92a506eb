// app/cli: the options of every verb that evaluates a scene and does not render it.
#pragma once

#include "app/cli/arguments.h"
#include "app/cli/load_scene.h"

namespace alhazen {

struct SceneOptions {
  std::string scene;
  std::vector<parser::Define> defines;
  bool allow_outside = false;
  std::string color_file;
};

void add_scene_options(CommandLine& line, SceneOptions& options);

// `--format text|json` and `--json` of a verb whose text goes to `text_goes`.
void add_format_options(CommandLine& line, std::string_view text_goes, bool& as_json);

// load_scene with these options.
std::optional<ExitCode> load_scene(const SceneOptions& options, LoadedScene& loaded);
Result<parser::EvalOptions> eval_options(const SceneOptions& options);

}  // namespace alhazen
