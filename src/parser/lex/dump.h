// parser/lex: tokens as text, for `alhazen dump --tokens` and for tests.
#pragma once

#include <string>

#include "core/diag/source.h"

namespace alhazen::parser {

// One token a line: "line:column kind text", and the flaw if it has one.
std::string dump_tokens(FileId file, const SourceManager& sources);

}  // namespace alhazen::parser
