// tests/fuzz: any bytes are tokens, in order, without overlap, up to the end.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/diag/render_text.h"
#include "parser/lex/header.h"
#include "parser/lex/lexer.h"
#include "parser/lex/report.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace alhazen;
  SourceManager sources;
  const FileId file = sources.add("fuzz.scn", std::string(data, data + size));
  const std::string_view text = sources.text(file);
  DiagnosticSink sink;
  parser::report(parser::read_header(file, text), text, sink);
  parser::Lexer lexer(text);
  std::uint32_t last_end = 0;
  for (parser::Token token = lexer.next();; token = lexer.next()) {
    if (token.begin < last_end || token.end < token.begin || token.end > size) std::abort();
    last_end = token.end;
    if (token.flaw != parser::Flaw::none && !sink.full()) {
      const std::size_t before = sink.diagnostics().size();
      parser::report_flaw(token, file, text, sink);
      // Every flaw has something to say, unless something was said at that place.
      if (before == 0 && sink.diagnostics().empty()) std::abort();
    }
    if (token.kind == parser::TokenKind::end) break;
    if (token.end == token.begin) std::abort();
  }
  render_text(sink, sources);
  render_json(sink, sources);
  return 0;
}
