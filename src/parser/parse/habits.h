// parser/parse: words that people bring along from other languages, and slips of the finger.
#pragma once

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

}  // namespace alhazen::parser
