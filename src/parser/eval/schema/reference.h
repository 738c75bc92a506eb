// parser/eval: the reference manual of the language, from the tables that the evaluator checks by.
#pragma once

#include <string>

namespace alhazen::parser {

// docs/reference.md, as Markdown. A test keeps the file up to date.
std::string schema_reference_markdown();

}  // namespace alhazen::parser
