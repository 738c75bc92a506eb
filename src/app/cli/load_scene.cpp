#include "app/cli/load_scene.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "app/cli/streams.h"
#include "core/diag/render_text.h"

namespace alhazen {

Result<parser::EvalOptions> eval_options(const render::ColorConfig& colors,
                                         std::vector<parser::Define> defines,
                                         parser::FileAccess files) {
  const Result<ColorMatrix> matrix = colors.working_from_rec709();
  if (!matrix) return matrix.error();
  parser::EvalOptions options;
  options.defines = std::move(defines);
  options.files = files;
  auto out = options.working_from_rec709.begin();
  for (const auto& row : matrix.value().rows)
    out = std::ranges::copy(row, out).out;
  return options;
}

std::optional<ExitCode> load_scene(const std::string& path, const parser::EvalOptions& options,
                                   LoadedScene& loaded) {
  loaded.evaluation = parser::evaluate_file(path, loaded.sources, loaded.sink, options);
  for (const parser::PrintedLine& line : loaded.evaluation.printed) {
    write_stderr(fmt::format("{}: {}\n", loaded.sources.describe(line.span), line.text));
  }
  show_diagnostics(loaded.sink, loaded.sources);
  if (loaded.evaluation.scene) return std::nullopt;
  return exit_code(loaded.sink.code());
}

void show_diagnostics(const DiagnosticSink& sink, const SourceManager& sources) {
  if (sink.diagnostics().empty()) return;
  write_stderr(render_text(sink, sources, TextStyle{stderr_takes_color()}));
}

}  // namespace alhazen
