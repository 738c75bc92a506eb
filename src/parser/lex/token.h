// parser/lex: one token. It owns nothing; its text is a span of the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace alhazen::parser {

enum class TokenKind : std::uint8_t {
#define ALHAZEN_TOKEN(kind, description) kind,
#define ALHAZEN_PUNCTUATION(kind, spelling) kind,
#define ALHAZEN_KEYWORD(kind, spelling) kind,
#include "parser/lex/token.def"
#undef ALHAZEN_TOKEN
#undef ALHAZEN_PUNCTUATION
#undef ALHAZEN_KEYWORD
};

// What is wrong with a token. Its kind is then what the author most likely meant, so that the
// parser goes on as if it had been written right.
enum class Flaw : std::uint8_t {
#define ALHAZEN_FLAW(flaw) flaw,
#include "parser/lex/flaw.def"
#undef ALHAZEN_FLAW
};

struct Token {
  std::uint32_t begin = 0;  // bytes [begin, end) of the file
  std::uint32_t end = 0;
  TokenKind kind = TokenKind::end;
  Flaw flaw = Flaw::none;
  bool newline_before = false;     // between it and the token before, comments included
  bool blank_line_before = false;  // directly before it
};
static_assert(sizeof(Token) <= 12, "the lexer makes one for every few bytes of text");

// "`{`", "`let`", "a name": for messages.
std::string_view describe(TokenKind kind);

// The identifier of the kind, for dumps.
std::string_view name_of(TokenKind kind);
std::string_view name_of(Flaw flaw);

// The spelling of punctuation and keywords, "" for the other kinds.
std::string_view spelling(TokenKind kind);

// The longest punctuation that `text` begins with.
std::optional<TokenKind> match_punctuation(std::string_view text);

// The keyword that `word` is, or `name`.
TokenKind keyword_or_name(std::string_view word);

}  // namespace alhazen::parser
