// tests/fuzz: any text is an NFF scene or errors; what a scene is written as has no mistake, and is
// in canonical layout.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "app/nff/read.h"
#include "app/nff/write_scn.h"
#include "core/diag/render_text.h"
#include "parser/eval/evaluate.h"
#include "parser/parse/parse.h"
#include "parser/print/format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace alhazen;
  SourceManager sources;
  DiagnosticSink sink;
  const FileId nff = sources.add("fuzz.nff", std::string(data, data + size));
  const std::optional<NffScene> scene = read_nff(nff, sources, sink);
  render_text(sink, sources);
  if (scene.has_value() == (sink.error_count() > 0)) std::abort();
  if (!scene) return 0;

  const std::string scn = write_scn(*scene, "fuzz.nff");
  const FileId file = sources.add("fuzz.scn", scn);
  DiagnosticSink scn_sink;
  const ast::File tree = parser::parse(file, sources, scn_sink);
  if (scn_sink.error_count() > 0 || parser::format(tree, sources) != scn) std::abort();
  parser::EvalOptions options;
  options.files = parser::FileAccess::none;
  const auto evaluation = parser::evaluate_text(file, "", sources, scn_sink, options);
  if (!evaluation.scene) std::abort();
  return 0;
}
