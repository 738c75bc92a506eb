// app/cli: a scene file in, its mistakes on stderr: the beginning of every verb that reads scenes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/exit_code.h"
#include "core/diag/diagnostic.h"
#include "parser/eval/evaluate.h"
#include "render/color/color_config.h"

namespace alhazen {

struct LoadedScene {
  SourceManager sources;
  DiagnosticSink sink;
  parser::Evaluation evaluation;
};

// What evaluation needs to know of the colour configuration. Fails as
// ColorConfig::working_from_rec709 does.
Result<parser::EvalOptions> eval_options(const render::ColorConfig& colors,
                                         std::vector<parser::Define> defines,
                                         parser::FileAccess files);

// Evaluates the scene; `print` lines and diagnostics go to stderr. A code means that there is no
// scene.
std::optional<ExitCode> load_scene(const std::string& path, const parser::EvalOptions& options,
                                   LoadedScene& loaded);

// The diagnostics so far, on stderr; in colour where stderr takes it.
void show_diagnostics(const DiagnosticSink& sink, const SourceManager& sources);

}  // namespace alhazen
