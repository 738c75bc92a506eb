// tests/fuzz: any text is a tree or errors; a tree can be dumped, and formatted without changing
// it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/diag/render_text.h"
#include "parser/ast/dump.h"
#include "parser/parse/parse.h"
#include "parser/print/format.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace alhazen;
  SourceManager sources;
  const auto parse = [&](std::string text, DiagnosticSink& sink) {
    return parser::parse(sources.add("fuzz.scn", std::move(text)), sources, sink);
  };
  // Without a header every input would end at the first line.
  DiagnosticSink sink;
  const ast::File tree = parse("#scn 1\n" + std::string(data, data + size), sink);
  const std::string dump = ast::dump(tree);
  render_text(sink, sources);
  if (sink.error_count() > 0) return 0;

  const std::string formatted = parser::format(tree, sources);
  DiagnosticSink second_sink;
  const ast::File second = parse(formatted, second_sink);
  if (second_sink.error_count() > 0 || ast::dump(second) != dump) std::abort();
  if (parser::format(second, sources) != formatted) std::abort();
  return 0;
}
