// tests/support: what `alhazen check` does to a text, for tests of diagnostics.
#pragma once

#include <string>

#include "core/diag/diagnostic.h"
#include "parser/ast/ast.h"
#include "parser/eval/evaluate.h"

namespace alhazen::test {

struct FrontEnd {
  SourceManager sources;
  DiagnosticSink sink;
  ast::File tree;

  std::string errors() const;  // as a person reads them
};

// Reads and parses. `name` is what the messages show.
FrontEnd front_end(std::string name, std::string text);

// The same, and evaluates if there was no error; files are relative to `folder`.
FrontEnd check(std::string name, std::string text, const std::filesystem::path& folder,
               const parser::EvalOptions& options = {});

}  // namespace alhazen::test
