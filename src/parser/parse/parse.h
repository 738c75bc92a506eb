// parser/parse: text to tree by recursive descent. Never throws, never stops at the first error.
#pragma once

#include "core/diag/diagnostic.h"
#include "parser/ast/ast.h"

namespace alhazen::parser {

struct ParseLimits {
  int max_nesting = 200;  // of expressions and bodies together: keeps the stack bounded
};

// The tree of one file. Errors go to `sink`; where they do, the tree holds ErrorExpr and ErrorItem
// nodes and is not to be evaluated.
ast::File parse(FileId file, const SourceManager& sources, DiagnosticSink& sink,
                const ParseLimits& limits = {});

}  // namespace alhazen::parser
