// tests/support: what `alhazen check` does to a text, for tests of diagnostics.
#pragma once

#include <string>

#include "core/diag/diagnostic.h"
#include "parser/ast/ast.h"

namespace alhazen::test {

struct FrontEnd {
  SourceManager sources;
  DiagnosticSink sink;
  ast::File tree;

  std::string errors() const;  // as a person reads them
};

// `name` is what the messages show.
FrontEnd front_end(std::string name, std::string text);

}  // namespace alhazen::test
