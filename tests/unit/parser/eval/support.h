// tests: evaluating a text without files.
#pragma once

#include <string>

#include "core/diag/render_text.h"
#include "parser/eval/evaluate.h"

namespace alhazen::parser {

struct Evaluated {
  SourceManager sources;
  DiagnosticSink sink;
  Evaluation result;

  std::string diagnostics() const { return render_text(sink, sources); }
  bool has_error(DiagnosticKind kind) const {
    for (const Diagnostic& d : sink.diagnostics()) {
      if (d.kind == kind) return true;
    }
    return false;
  }
  // What the first diagnostic points at.
  std::string first_operand() const {
    if (sink.diagnostics().empty()) return "";
    return std::string(sources.text(sink.diagnostics()[0].span));
  }
  const Scene& scene() const { return *result.scene; }
};

// Defined once for all tests of this room: Evaluated is neither copied nor moved.
inline void evaluate_into(Evaluated& out, const std::string& body, EvalOptions options = {}) {
  options.files = FileAccess::none;
  const FileId file = out.sources.add("t.scn", "#scn 1\n" + body + "\n");
  out.result = evaluate_text(file, "/", out.sources, out.sink, options);
}

inline constexpr const char* kCamera =
    "camera perspective { position <0, 1, -5> }\n"
    "light point { position <5, 8, -5> }\n";

// What `print expression` shows, or the diagnostics.
inline std::string value_of(const std::string& expression, const EvalOptions& options = {}) {
  Evaluated e;
  evaluate_into(e, kCamera + ("print " + expression), options);
  if (e.result.printed.size() == 1 && e.result.scene) return e.result.printed[0].text;
  return e.diagnostics();
}

}  // namespace alhazen::parser
