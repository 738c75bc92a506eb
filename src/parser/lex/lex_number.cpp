// parser/lex: NUMBER and ANGLE.
#include "parser/lex/characters.h"
#include "parser/lex/lexer.h"
#include "parser/lex/literal.h"

namespace alhazen::parser {

void Lexer::skip_digits() {
  while (is_digit(peek()))
    ++at_;
}

void Lexer::lex_number(Token& token) {
  token.kind = TokenKind::number;
  skip_digits();
  if (peek() == '.' && peek(1) != '.') {  // `1..3` is a range
    ++at_;
    if (!is_digit(peek())) token.flaw = Flaw::malformed_number;  // `1.`
    skip_digits();
    while (peek() == '.' && is_digit(peek(1))) {  // `1.2.3`
      token.flaw = Flaw::malformed_number;
      ++at_;
      skip_digits();
    }
  }
  const bool has_exponent = peek() == 'e' || peek() == 'E';
  if (has_exponent) {
    const std::uint32_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if (is_digit(peek(1 + sign))) {
      at_ += 1 + sign;
      skip_digits();
    } else if (sign > 0 || !continues_name(peek(1))) {  // `1e`, `1e+`
      at_ += 1 + sign;
      token.flaw = Flaw::malformed_number;
    }
  }
  const std::uint32_t unit_begin = at_;
  skip_word();
  const std::string_view unit = text_.substr(unit_begin, at_ - unit_begin);
  if (unit == "deg" || unit == "rad") {
    token.kind = TokenKind::angle;
  } else if (!unit.empty()) {
    token.flaw = Flaw::unknown_unit;
  }
  // So few digits cannot leave the range of double (1e-307 to 1e308) without an exponent.
  constexpr std::uint32_t kFewDigits = 300;
  const bool may_be_out_of_range = has_exponent || at_ - token.begin > kFewDigits;
  if (token.flaw == Flaw::none && may_be_out_of_range) check_number(token);
}

void Lexer::check_number(Token& token) {
  switch (read_number(text_.substr(token.begin, at_ - token.begin)).state) {
    case NumberState::good:
      break;
    case NumberState::too_large:
      token.flaw = Flaw::number_too_large;
      break;
    case NumberState::too_small:
      token.flaw = Flaw::number_too_small;
      break;
  }
}

}  // namespace alhazen::parser
