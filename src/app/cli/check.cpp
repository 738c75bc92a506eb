// app/cli: alhazen check: every mistake in a scene, for people and for editors.
#include <fmt/format.h>

#include "app/cli/scene_options.h"
#include "app/cli/streams.h"
#include "core/diag/render_text.h"

namespace alhazen {
namespace {

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

ExitCode check_as_json(const SceneOptions& options) {
  const auto eval = eval_options(options);
  if (!eval) return report(eval.error());
  LoadedScene loaded;
  loaded.evaluation =
      parser::evaluate_file(options.scene, loaded.sources, loaded.sink, eval.value());
  const ExitCode written = print(render_json(loaded.sink, loaded.sources));
  if (written != ExitCode::done || loaded.evaluation.scene) return written;
  return exit_code(loaded.sink.code());
}

}  // namespace

ExitCode run_check(const Arguments& arguments) {
  CommandLine line("check",
                   "Reads a scene, evaluates it and reports every mistake, without rendering.",
                   "  alhazen check scene.scn\n"
                   "  alhazen check scene.scn --format json | jq .diagnostics\n");
  SceneOptions options;
  bool json = false;
  add_scene_options(line, options);
  add_format_options(line, "stderr", json);
  if (const auto code = line.read(arguments)) return *code;
  if (json) return check_as_json(options);

  LoadedScene loaded;
  if (const auto code = load_scene(options, loaded)) return *code;
  const Scene& scene = *loaded.evaluation.scene;
  write_stderr(fmt::format(
      "{}: no mistakes: {}, {}, {}\n", options.scene, counted(scene.shapes.size(), "shape"),
      counted(scene.lights.size(), "light"), counted(scene.materials.size(), "material")));
  return ExitCode::done;
}

}  // namespace alhazen
