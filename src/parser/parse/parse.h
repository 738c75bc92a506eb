// parser/parse: text to tree by recursive descent. Never throws, never stops at the first error.
#pragma once

#include <cstdint>

#include "core/diag/diagnostic.h"
#include "parser/ast/ast.h"

namespace alhazen::parser {

// A limit exceeded is a diagnostic. The evaluator and the printer walk the tree by
// recursion: the second limit bounds their stack, also for a + a + a + ..., which is deep to the
// left.
struct ParseLimits {
  int max_nesting = 200;  // of expressions and bodies together, as written
  int max_height = 1000;  // of the tree of one expression
};

// The tree of one file. Errors go to `sink`; where they do, the tree holds ErrorExpr and ErrorItem
// nodes and is not to be evaluated.
ast::File parse(FileId file, const SourceManager& sources, DiagnosticSink& sink,
                const ParseLimits& limits = {});

// The expression that the text is from byte `begin` to its end. Its root is null if something is
// wrong with it, which is reported, or if something follows it, which is not.
ast::WholeExpr parse_expression(FileId file, std::uint32_t begin, const SourceManager& sources,
                                DiagnosticSink& sink, const ParseLimits& limits = {});

}  // namespace alhazen::parser
