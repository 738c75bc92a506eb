#include "parser/lex/foreign.h"

#include <algorithm>
#include <iterator>

namespace alhazen::parser {
namespace {

constexpr Foreign kOperators[] = {
#define ALHAZEN_FOREIGN(spelling, kind, hint) {spelling, TokenKind::kind, hint},
#define ALHAZEN_DIRECTIVE(spelling, kind, hint)
#include "parser/lex/foreign.def"
#undef ALHAZEN_FOREIGN
#undef ALHAZEN_DIRECTIVE
};

constexpr Foreign kDirectives[] = {
#define ALHAZEN_FOREIGN(spelling, kind, hint)
#define ALHAZEN_DIRECTIVE(spelling, kind, hint) {spelling, TokenKind::kind, hint},
#include "parser/lex/foreign.def"
#undef ALHAZEN_FOREIGN
#undef ALHAZEN_DIRECTIVE
};

struct Entry {
  char32_t code_point;
  std::string_view taken_for, write;
};

constexpr Entry kLookAlikes[] = {
#define ALHAZEN_LOOK_ALIKE(code_point, taken_for, write) {code_point, taken_for, write},
#include "parser/lex/look_alike.def"
#undef ALHAZEN_LOOK_ALIKE
};

TokenKind kind_of(std::string_view text) {
  return match_punctuation(text).value_or(TokenKind::skip);
}

}  // namespace

const Foreign* match_foreign_operator(std::string_view text) {
  const auto* found = std::find_if(std::begin(kOperators), std::end(kOperators),
                                   [&](const Foreign& f) { return text.starts_with(f.spelling); });
  return found == std::end(kOperators) ? nullptr : found;
}

const Foreign* match_directive(std::string_view text) {
  const auto* found = std::find_if(std::begin(kDirectives), std::end(kDirectives),
                                   [&](const Foreign& f) { return text == f.spelling; });
  return found == std::end(kDirectives) ? nullptr : found;
}

std::optional<LookAlike> match_look_alike(char32_t code_point) {
  // The full-width forms repeat ASCII in order (Unicode, block FF00).
  if (code_point >= 0xFF01 && code_point <= 0xFF5E) {
    const std::string ascii(1, static_cast<char>(code_point - 0xFEE0));
    return LookAlike{kind_of(ascii), "`" + ascii + "`"};
  }
  for (const Entry& entry : kLookAlikes) {
    if (entry.code_point == code_point) {
      return LookAlike{kind_of(entry.taken_for), std::string(entry.write)};
    }
  }
  return std::nullopt;
}

bool opens_foreign_string(char32_t code_point) {
  return code_point == U'\'' || code_point == U'`' ||
         (code_point >= 0x2018 && code_point <= 0x201F) || code_point == 0x00AB ||
         code_point == 0x00BB;
}

bool closes_foreign_string(char32_t opener, char32_t code_point) {
  if (opener == U'\'' || opener == U'`') return code_point == opener;
  return code_point == U'"' || opens_foreign_string(code_point);
}

}  // namespace alhazen::parser
