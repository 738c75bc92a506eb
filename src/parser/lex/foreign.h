// parser/lex: spellings and characters that are not ours but whose meaning can be guessed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/lex/token.h"

namespace alhazen::parser {

struct Foreign {
  std::string_view spelling;
  TokenKind kind;  // what it is taken for
  std::string_view hint;
};

// The foreign operator that `text` begins with, or the directive that is all of `text`, or null.
const Foreign* match_foreign_operator(std::string_view text);
const Foreign* match_directive(std::string_view text);

struct LookAlike {
  TokenKind kind;     // what it is taken for; `skip` for white space and the like
  std::string write;  // what to write in its place, for the hint
};
std::optional<LookAlike> match_look_alike(char32_t code_point);

// Single, curly and other quotation marks that open a string elsewhere.
bool opens_foreign_string(char32_t code_point);
bool closes_foreign_string(char32_t opener, char32_t code_point);

}  // namespace alhazen::parser
