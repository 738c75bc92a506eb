// parser/lex: text to tokens, one at a time. Never fails: a broken token is a token with a flaw.
#pragma once

#include <string_view>

#include "core/diag/source.h"
#include "parser/lex/token.h"

namespace alhazen::parser {

class Lexer {
 public:
  // Reads `text` from byte `begin` on: after the header. `text` outlives the lexer.
  explicit Lexer(std::string_view text, std::uint32_t begin = 0) : text_(text), at_(begin) {}

  // The next token, comments included; after the last one, `end` for ever.
  Token next();

 private:
  // The kinds of token, each from the current byte on; they set the kind, the flaw and at_.
  void lex_number(Token& token);
  void lex_word(Token& token);
  void lex_string(Token& token);
  void lex_foreign_string(Token& token, char32_t opener);
  void lex_line_comment(Token& token);
  void lex_block_comment(Token& token);
  void lex_hash(Token& token);
  void lex_beyond_ascii(Token& token);
  void lex_punctuation(Token& token);

  void skip_white_space(Token& token);
  void skip_operands(std::string_view stops);
  void skip_digits();
  bool skip_word();  // letters, digits, _ and what is not ASCII; false if some was not
  void check_number(Token& token);
  bool at_end() const { return at_ >= text_.size(); }
  char peek(std::uint32_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  std::string_view rest() const { return text_.substr(at_); }

  std::string_view text_;
  std::uint32_t at_;
};

}  // namespace alhazen::parser
