// parser/eval: the entry: a text to a scene.
#include "parser/eval/evaluate.h"

#include <bit>

#include "core/base/file.h"
#include "core/base/hash.h"
#include "parser/eval/block_builder.h"
#include "parser/eval/check_scene.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/flatten.h"
#include "parser/eval/lower.h"

namespace alhazen::parser {
namespace {

std::uint64_t scene_hash(std::uint64_t texts, const EvalOptions& options) {
  std::uint64_t hash = texts;
  for (const Define& define : options.defines) {
    hash = fnv1a_64(define.name, hash);
    hash = fnv1a_64("=" + define.text + "\n", hash);
  }
  for (const double entry : options.working_from_rec709)
    hash = mix_64(hash, std::bit_cast<std::uint64_t>(entry));
  return hash;
}

// The scene of a file whose items have run; nothing after a report.
std::optional<Scene> build(Context& context, BlockBuilder& builder, std::uint64_t hash) {
  const Properties* properties = builder.finish();
  if (!properties || context.sink().error_count() > 0) return std::nullopt;
  const auto camera = lower_camera(context, *properties->find("camera")->block);
  std::optional<Background> background = Background{};
  if (const Property* p = properties->find("background"))
    background = lower_background(context, *p);
  std::optional<RenderSettings> settings = RenderSettings{};
  if (const Property* p = properties->find("render")) settings = lower_render(context, *p->block);
  if (!camera || !background || !settings) return std::nullopt;
  Scene scene;
  scene.camera = *camera;
  scene.background = std::move(*background);
  scene.settings = *settings;
  scene.hash = hash;
  flatten(context, *builder.finish_group(), scene);
  if (context.sink().error_count() == 0) check_scene(context, scene);
  if (context.sink().error_count() > 0) return std::nullopt;
  return scene;
}

Evaluation evaluate(FileId file, const std::filesystem::path& path,
                    const std::filesystem::path& root, SourceManager& sources, DiagnosticSink& sink,
                    const EvalOptions& options) {
  Evaluation out;
  out.files_read.push_back(path);
  Context context(sources, sink, options);
  context.set_root(root);
  Evaluator evaluator(context, out);
  // The camera and the like are missed at the header, not at the first thing that happens to stand
  // in the file.
  const auto end_of_line = static_cast<std::uint32_t>(sources.text(file).substr(0, 6).size());
  BlockBuilder builder(evaluator, scene_schema(), {file, 0, end_of_line});
  const bool ran = evaluator.run_file(file, path, {evaluator.root_scope(), builder, nullptr});
  // What seems to be missing may stand in a file that could not be read.
  if (ran && !context.halted() && !evaluator.include_failed()) {
    evaluator.report_unused_defines();
    out.scene = build(context, builder, scene_hash(evaluator.text_hash(), options));
  }
  sink.set_trace({});
  return out;
}

}  // namespace

Evaluation evaluate_file(const std::filesystem::path& path, SourceManager& sources,
                         DiagnosticSink& sink, const EvalOptions& options) {
  auto text = read_file(path, options.limits.source_bytes);
  if (!text) {
    const Error& error = text.error();
    if (error.code == ErrorCode::limit) {
      sink.report<DiagnosticKind::texts_too_large>({}, path.string(), options.limits.source_bytes);
    } else {
      sink.report<DiagnosticKind::scene_unreadable>({}, error.message);
    }
    return {};
  }
  const FileId file = sources.add(path.string(), std::move(text).value());
  std::error_code ignored;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, ignored);
  return evaluate(file, canonical, canonical.parent_path(), sources, sink, options);
}

Evaluation evaluate_text(FileId file, const std::filesystem::path& folder, SourceManager& sources,
                         DiagnosticSink& sink, const EvalOptions& options) {
  std::error_code ignored;
  const std::filesystem::path root = std::filesystem::weakly_canonical(folder, ignored);
  return evaluate(file, root / sources.name(file), root, sources, sink, options);
}

}  // namespace alhazen::parser
