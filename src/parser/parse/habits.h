// parser/parse: words that people bring along from other languages, and slips of the finger.
#pragma once

#include <span>
#include <string_view>

#include "parser/lex/token.h"

namespace alhazen::parser {

struct ForeignWord {
  std::string_view spelling;
  TokenKind meaning;  // the keyword it is read as, or `skip`
  std::string_view hint;
};

// Null if `word` is none.
const ForeignWord* match_foreign_word(std::string_view word);

// The keyword that begins an item and that `word` is one slip away from: a letter wrong, missing,
// too many, or two swapped. "" if there is none.
std::string_view nearest_keyword(std::string_view word);

// How a block is written whose values somebody gives by their order, as POV-Ray has them: "" for
// blocks that have none there.
std::string_view named_values_example(std::string_view block);

// The blocks that named_values_example knows.
std::span<const std::string_view> positional_blocks();

}  // namespace alhazen::parser
