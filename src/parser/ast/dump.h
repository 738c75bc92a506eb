// parser/ast: the tree as indented text, one node a line, for `alhazen dump --ast` and for tests.
#pragma once

#include <string>

#include "parser/ast/ast.h"

namespace alhazen::ast {

struct DumpStyle {
  bool spans = false;     // the bytes of each node: " @12-15"
  bool comments = false;  // comments and blank lines, which change nothing in the picture
};

std::string dump(const File& file, DumpStyle style = {});

}  // namespace alhazen::ast
