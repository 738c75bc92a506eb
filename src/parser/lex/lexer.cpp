#include "parser/lex/lexer.h"

#include "parser/lex/characters.h"
#include "parser/lex/foreign.h"
#include "parser/lex/utf8.h"

namespace alhazen::parser {

Token Lexer::next() {
  Token token;
  skip_white_space(token);
  token.begin = at_;
  if (at_end()) {
    token.kind = TokenKind::end;
  } else if (const char c = peek(); begins_name(c)) {
    lex_word(token);
  } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
    lex_number(token);
  } else if (c == '"') {
    lex_string(token);
  } else if (c == '\'' || c == '`') {
    lex_foreign_string(token, static_cast<char32_t>(c));
  } else if (rest().starts_with("//")) {
    lex_line_comment(token);
  } else if (rest().starts_with("/*")) {
    lex_block_comment(token);
  } else if (c == '#') {
    lex_hash(token);
  } else if (is_beyond_ascii(c)) {
    lex_beyond_ascii(token);
  } else {
    lex_punctuation(token);
  }
  token.end = at_;
  return token;
}

void Lexer::skip_white_space(Token& token) {
  int line_breaks = 0;
  for (; !at_end() && (is_blank(peek()) || peek() == '\n'); ++at_) {
    if (peek() == '\n') ++line_breaks;
  }
  token.newline_before = line_breaks > 0;
  token.blank_line_before = line_breaks > 1;
}

// Letters of other alphabets do not end a word: `größe` is one wrong name, not three tokens, and so
// it is in Latin-1, where the bytes of its letters are not UTF-8.
bool Lexer::skip_word() {
  bool ascii = true;
  while (!at_end()) {
    if (is_beyond_ascii(peek())) {
      const CodePoint code = decode_utf8(rest());
      if (match_look_alike(code.value) || opens_foreign_string(code.value)) break;
      at_ += code.length;
      ascii = false;
    } else if (continues_name(peek())) {
      ++at_;
    } else {
      break;
    }
  }
  return ascii;
}

void Lexer::lex_word(Token& token) {
  const bool ascii = skip_word();
  token.kind = keyword_or_name(text_.substr(token.begin, at_ - token.begin));
  if (!ascii) token.flaw = Flaw::non_ascii_name;
}

// To the end of the line, or to one of `stops`: the rest of what has no counterpart here.
void Lexer::skip_operands(std::string_view stops) {
  while (!at_end() && peek() != '\n' && stops.find(peek()) == std::string_view::npos)
    ++at_;
}

void Lexer::lex_line_comment(Token& token) {
  token.kind = TokenKind::comment;
  while (!at_end() && peek() != '\n')
    ++at_;
  while (is_blank(text_[at_ - 1]))
    --at_;  // the blanks before a line break are nobody's
}

void Lexer::lex_block_comment(Token& token) {
  token.kind = TokenKind::comment;
  int depth = 0;
  while (!at_end()) {
    if (rest().starts_with("/*")) {
      ++depth;
      at_ += 2;
    } else if (rest().starts_with("*/")) {
      --depth;
      at_ += 2;
      if (depth == 0) return;
    } else {
      ++at_;
    }
  }
  token.flaw = Flaw::unterminated_comment;
}

// A colour, a directive of POV-Ray, a header out of place, or a comment as scripts write it.
void Lexer::lex_hash(Token& token) {
  ++at_;
  if (!continues_name(peek())) {
    lex_line_comment(token);
    token.flaw = Flaw::foreign_spelling;
    return;
  }
  bool hex = true;
  while (continues_name(peek()))
    hex = is_hex_digit(text_[at_++]) && hex;
  const std::string_view word = text_.substr(token.begin, at_ - token.begin);
  const std::size_t digits = word.size() - 1;
  if (hex && (digits == 3 || digits == 6)) {
    token.kind = TokenKind::hex_color;
  } else if (const Foreign* directive = match_directive(word)) {
    token.kind = directive->kind;
    token.flaw = Flaw::foreign_spelling;
    if (token.kind == TokenKind::skip) skip_operands("");
  } else if (word == "#scn") {
    lex_line_comment(token);
    token.kind = TokenKind::skip;
    token.flaw = Flaw::misplaced_header;
  } else {
    token.kind = TokenKind::hex_color;
    token.flaw = Flaw::malformed_color;
  }
}

void Lexer::lex_beyond_ascii(Token& token) {
  const CodePoint code = decode_utf8(rest());
  if (opens_foreign_string(code.value)) {
    lex_foreign_string(token, code.value);
  } else if (const auto look_alike = match_look_alike(code.value)) {
    at_ += code.length;
    token.kind = look_alike->kind;
    token.flaw = Flaw::look_alike;
  } else {
    lex_word(token);
  }
}

void Lexer::lex_punctuation(Token& token) {
  const auto ours = match_punctuation(rest());
  // `**`, `:=` and `!` begin with one of ours or are one's beginning: the longer wins.
  const Foreign* foreign = match_foreign_operator(rest());
  if (foreign != nullptr && (!ours || foreign->spelling.size() > spelling(*ours).size())) {
    token.kind = foreign->kind;
    token.flaw = Flaw::foreign_spelling;
    at_ += static_cast<std::uint32_t>(foreign->spelling.size());
    if (foreign->spelling == "?") skip_operands("{}()[],");
  } else if (ours) {
    // `<1, 2>==a` compares a vector: `>==` is `>` and `==`, nothing else could follow from it.
    token.kind = rest().starts_with(">==") ? TokenKind::greater : *ours;
    at_ += static_cast<std::uint32_t>(spelling(token.kind).size());
  } else {
    token.kind = TokenKind::skip;
    token.flaw = Flaw::unexpected_character;
    ++at_;
  }
}

}  // namespace alhazen::parser
