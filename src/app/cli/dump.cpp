// app/cli: alhazen dump: what each step makes of a scene, as text.
#include "parser/ast/dump.h"

#include <fmt/format.h>

#include "app/cli/explain_plan.h"
#include "app/cli/scene_options.h"
#include "app/cli/streams.h"
#include "core/base/file.h"
#include "parser/lex/dump.h"
#include "parser/parse/parse.h"

namespace alhazen {
namespace {

struct Source {
  SourceManager sources;
  FileId file = kNoFile;
};

std::optional<ExitCode> read_source(const std::string& path, Source& source) {
  Result<std::string> text = read_file(path, parser::EvalLimits{}.source_bytes);
  if (!text) return report(text.error());
  source.file = source.sources.add(path, std::move(text).value());
  return std::nullopt;
}

ExitCode dump_tokens(const SceneOptions& options) {
  Source source;
  if (const auto code = read_source(options.scene, source)) return *code;
  return print(parser::dump_tokens(source.file, source.sources));
}

// The tree is shown even where it has holes; the code tells.
ExitCode dump_ast(const SceneOptions& options) {
  Source source;
  if (const auto code = read_source(options.scene, source)) return *code;
  DiagnosticSink sink;
  const ast::File tree = parser::parse(source.file, source.sources, sink);
  show_diagnostics(sink, source.sources);
  const ExitCode written = print(ast::dump(tree));
  if (written != ExitCode::done || sink.error_count() == 0) return written;
  return exit_code(sink.code());
}

ExitCode dump_scene(const SceneOptions& options) {
  LoadedScene loaded;
  if (const auto code = load_scene(options, loaded)) return *code;
  return print(dump(*loaded.evaluation.scene));
}

ExitCode dump_plan(const SceneOptions& options) {
  LoadedScene loaded;
  if (const auto code = load_scene(options, loaded)) return *code;
  const Scene& scene = *loaded.evaluation.scene;
  const EffectSet effects = render::effects_of(scene);
  const render::StagePlan plan = render::make_plan(scene, effects);
  return print(explain_text({effects, plan, loaded.sources}));
}

}  // namespace

ExitCode run_dump(const Arguments& arguments) {
  CommandLine line("dump", "Prints one of the forms that a scene takes on its way to a picture.",
                   "  alhazen dump scene.scn --ast\n"
                   "  diff <(alhazen dump a.scn --scene) <(alhazen dump b.scn --scene)\n");
  SceneOptions options;
  bool tokens = false, tree = false, scene = false, plan = false;
  add_scene_options(line, options);
  line.begin_group("What to print, exactly one of");
  line.flag("--tokens", tokens, "the words of the text");
  line.flag("--ast", tree, "the syntax tree");
  line.flag("--scene", scene, "shapes, lights, materials as plain data");
  line.flag("--plan", plan, "the stages of the renderer");
  if (const auto code = line.read(arguments)) return *code;
  if (tokens + tree + scene + plan != 1) {
    return line.complain("exactly one of --tokens, --ast, --scene, --plan is needed");
  }
  if (tokens) return dump_tokens(options);
  if (tree) return dump_ast(options);
  return scene ? dump_scene(options) : dump_plan(options);
}

}  // namespace alhazen
