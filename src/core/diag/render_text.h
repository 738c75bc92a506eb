// core/diag: diagnostics as a person reads them in a terminal, and as data.
#pragma once

#include <string>

#include "core/diag/diagnostic.h"

namespace alhazen {

struct TextStyle {
  bool color = false;  // ANSI escape sequences
};

// One diagnostic: "file:line:column: error: message", the line, a caret range under the operand,
// labels, hints and the trace. Ends with a line break.
std::string render_text(const Diagnostic& diagnostic, const SourceManager& sources,
                        TextStyle style = {});

// All of them and, when some were dropped, a last line that says so.
std::string render_text(const DiagnosticSink& sink, const SourceManager& sources,
                        TextStyle style = {});

// {"diagnostics": [{kind, severity, message, span: {file, line, column, end_line, end_column},
// ...}],
//  "truncated": bool}
std::string render_json(const DiagnosticSink& sink, const SourceManager& sources);

}  // namespace alhazen
