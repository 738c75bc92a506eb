#include "parser/lex/token.h"

#include <cstddef>

#include "core/base/same_name.h"

namespace alhazen::parser {
namespace {

struct Spelling {
  TokenKind kind;
  std::string_view text;
};

constexpr Spelling kPunctuation[] = {
#define ALHAZEN_TOKEN(kind, description)
#define ALHAZEN_PUNCTUATION(kind, spelling) {TokenKind::kind, spelling},
#define ALHAZEN_KEYWORD(kind, spelling)
#include "parser/lex/token.def"
#undef ALHAZEN_TOKEN
#undef ALHAZEN_PUNCTUATION
#undef ALHAZEN_KEYWORD
};

constexpr Spelling kKeywords[] = {
#define ALHAZEN_TOKEN(kind, description)
#define ALHAZEN_PUNCTUATION(kind, spelling)
#define ALHAZEN_KEYWORD(kind, spelling) {TokenKind::kind, spelling},
#include "parser/lex/token.def"
#undef ALHAZEN_TOKEN
#undef ALHAZEN_PUNCTUATION
#undef ALHAZEN_KEYWORD
};

struct KindText {
  std::string_view name, description, spelling;
};

constexpr KindText kKinds[] = {
#define ALHAZEN_TOKEN(kind, description) {#kind, description, ""},
#define ALHAZEN_PUNCTUATION(kind, spelling) {#kind, "`" spelling "`", spelling},
#define ALHAZEN_KEYWORD(kind, spelling) {#kind, "`" spelling "`", spelling},
#include "parser/lex/token.def"
#undef ALHAZEN_TOKEN
#undef ALHAZEN_PUNCTUATION
#undef ALHAZEN_KEYWORD
};

constexpr const KindText& text_of(TokenKind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string_view describe(TokenKind kind) {
  return text_of(kind).description;
}
std::string_view name_of(TokenKind kind) {
  return text_of(kind).name;
}
std::string_view spelling(TokenKind kind) {
  return text_of(kind).spelling;
}

std::string_view name_of(Flaw flaw) {
  constexpr std::string_view kNames[] = {
#define ALHAZEN_FLAW(flaw) #flaw,
#include "parser/lex/flaw.def"
#undef ALHAZEN_FLAW
  };
  return kNames[static_cast<std::size_t>(flaw)];
}

std::optional<TokenKind> match_punctuation(std::string_view text) {
  for (const Spelling& candidate : kPunctuation) {
    if (same_name(text.substr(0, candidate.text.size()), candidate.text)) return candidate.kind;
  }
  return std::nullopt;
}

TokenKind keyword_or_name(std::string_view word) {
  for (const Spelling& candidate : kKeywords) {
    if (same_name(word, candidate.text)) return candidate.kind;
  }
  return TokenKind::name;
}

}  // namespace alhazen::parser
