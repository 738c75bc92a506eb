// parser/print: `alhazen fmt`: a file in its canonical layout.
#pragma once

#include <string>

#include "core/diag/source.h"
#include "parser/ast/ast.h"

namespace alhazen::parser {

inline constexpr int kLineWidth = 100;

// The same scene with an indentation of two columns and one item a line; comments, and single blank
// lines, are kept, and so is the spelling of every literal. What the author wrote on one line stays
// on one if it fits into kLineWidth. An item with a comment between its tokens stays as it is,
// unless it ends in a body; then the comment moves to the line above. Formatting twice changes
// nothing more. Precondition: the file was parsed without an error.
std::string format(const ast::File& file, const SourceManager& sources);

}  // namespace alhazen::parser
