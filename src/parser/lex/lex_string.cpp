// parser/lex: STRING, and what is meant for one.
#include "parser/lex/characters.h"
#include "parser/lex/foreign.h"
#include "parser/lex/lexer.h"
#include "parser/lex/utf8.h"

namespace alhazen::parser {

// The first flaw is the one reported. An unterminated string ends with its line, so that the rest
// of the file is not taken for the inside of it.
void Lexer::lex_string(Token& token) {
  token.kind = TokenKind::string;
  const auto flawed = [&](Flaw flaw) {
    if (token.flaw == Flaw::none) token.flaw = flaw;
  };
  ++at_;
  while (!at_end() && peek() != '\n') {
    const char c = peek();
    if (c == '"') {
      ++at_;
      return;
    }
    if (c == '\\') {
      const char escaped = peek(1);
      if (escaped == '"' || escaped == '\\' || escaped == 'n' || escaped == 't') {
        at_ += 2;
      } else {
        flawed(Flaw::unknown_escape);
        ++at_;
      }
    } else if (is_beyond_ascii(c)) {
      const CodePoint code = decode_utf8(rest());
      if (!code.valid) flawed(Flaw::invalid_utf8);
      at_ += code.length;
    } else {
      const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
      if (control && c != '\t' && !(c == '\r' && peek(1) == '\n')) flawed(Flaw::control_character);
      ++at_;
    }
  }
  while (is_blank(text_[at_ - 1]))
    --at_;
  token.flaw = Flaw::unterminated_string;
}

// 'text', `text` and text in curly quotes on one line; a lone mark is an unexpected character.
void Lexer::lex_foreign_string(Token& token, char32_t opener) {
  const std::uint32_t after_opener = at_ + decode_utf8(rest()).length;
  for (at_ = after_opener; !at_end() && peek() != '\n';) {
    const CodePoint code = decode_utf8(rest());
    at_ += code.length;
    if (code.valid && closes_foreign_string(opener, code.value)) {
      token.kind = TokenKind::string;
      token.flaw = Flaw::wrong_quotes;
      return;
    }
  }
  at_ = after_opener;
  token.kind = TokenKind::skip;
  token.flaw = Flaw::unexpected_character;
}

}  // namespace alhazen::parser
