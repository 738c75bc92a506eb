// parser/lex: what to say about a flawed token.
#pragma once

#include <string_view>

#include "core/diag/diagnostic.h"
#include "parser/lex/token.h"

namespace alhazen::parser {

// Precondition: the token has a flaw. `text` is that of the whole file.
void report_flaw(const Token& token, FileId file, std::string_view text, DiagnosticSink& sink);

}  // namespace alhazen::parser
