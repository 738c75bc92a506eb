// parser/ast: the tree as indented text, one node a line, for `alhazen dump --ast` and for tests.
#pragma once

#include <string>

#include "parser/ast/ast.h"

namespace alhazen::ast {

std::string dump(const File& file);

}  // namespace alhazen::ast
