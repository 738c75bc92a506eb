// parser/ast: how operators are written.
#pragma once

#include <string_view>

#include "parser/ast/ast.h"

namespace alhazen::ast {

std::string_view spelling(UnaryOperator op);
std::string_view spelling(BinaryOperator op);

}  // namespace alhazen::ast
