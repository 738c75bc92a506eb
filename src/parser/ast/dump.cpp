#include "parser/ast/dump.h"

namespace alhazen::ast {

std::string dump(const File&) { return ""; }

}  // namespace alhazen::ast
