#include "parser/lex/lexer.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace alhazen::parser {
namespace {

// "kind text" of each token but the last; "!" and the flaw where there is one.
std::vector<std::string> lex(std::string_view text) {
  std::vector<std::string> tokens;
  Lexer lexer(text);
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
    std::string line(name_of(token.kind));
    line += " " + std::string(text.substr(token.begin, token.end - token.begin));
    if (token.flaw != Flaw::none) line += " !" + std::string(name_of(token.flaw));
    tokens.push_back(line);
  }
  return tokens;
}

using Tokens = std::vector<std::string>;

TEST(Lexer, APointBetweenNumbers) {
  EXPECT_EQ(lex("1..3"), (Tokens{"number 1", "range ..", "number 3"}));
  EXPECT_EQ(lex("1..=3"), (Tokens{"number 1", "range_inclusive ..=", "number 3"}));
  EXPECT_EQ(lex("1.5...5"), (Tokens{"number 1.5", "range ..", "number .5"}));
  EXPECT_EQ(lex("a.b"), (Tokens{"name a", "dot .", "name b"}));
  EXPECT_EQ(lex("1."), (Tokens{"number 1. !malformed_number"}));
  EXPECT_EQ(lex("1.2.3"), (Tokens{"number 1.2.3 !malformed_number"}));
}

TEST(Lexer, UnitsDirectlyFollowTheNumber) {
  EXPECT_EQ(lex("40deg 1.5e2rad"), (Tokens{"angle 40deg", "angle 1.5e2rad"}));
  EXPECT_EQ(lex("40 deg"), (Tokens{"number 40", "name deg"}));
  EXPECT_EQ(lex("40degs"), (Tokens{"number 40degs !unknown_unit"}));
  EXPECT_EQ(lex("2e"), (Tokens{"number 2e !malformed_number"}));
  EXPECT_EQ(lex("2em"), (Tokens{"number 2em !unknown_unit"}));
}

TEST(Lexer, AVectorBeforeAnEquals) {
  EXPECT_EQ(lex("1>==a"), (Tokens{"number 1", "greater >", "equal_equal ==", "name a"}));
  EXPECT_EQ(lex("1>=a"), (Tokens{"number 1", "greater_equal >=", "name a"}));
}

TEST(Lexer, CommentsNest) {
  EXPECT_EQ(lex("/* a /* b */ c */ d"), (Tokens{"comment /* a /* b */ c */", "name d"}));
  EXPECT_EQ(lex("// a \t\r\nb"), (Tokens{"comment // a", "name b"}));
  EXPECT_EQ(lex("/* a /* b */"), (Tokens{"comment /* a /* b */ !unterminated_comment"}));
  EXPECT_EQ(lex("\"// a\""), (Tokens{"string \"// a\""}));
}

TEST(Lexer, ABrokenStringEndsWithItsLine) {
  EXPECT_EQ(lex("\"ab\nc"), (Tokens{"string \"ab !unterminated_string", "name c"}));
  EXPECT_EQ(lex("\"ab\r\nc"), (Tokens{"string \"ab !unterminated_string", "name c"}));
  EXPECT_EQ(lex(R"("a\"b")"), (Tokens{R"(string "a\"b")"}));
  EXPECT_EQ(lex(R"("a\b")"), (Tokens{R"(string "a\b" !unknown_escape)"}));
  EXPECT_EQ(lex("\"\xff\""), (Tokens{"string \"\xff\" !invalid_utf8"}));
  EXPECT_EQ(lex("\"\x01\""), (Tokens{"string \"\x01\" !control_character"}));
}

TEST(Lexer, AHashIsAColourOrForeign) {
  EXPECT_EQ(lex("#fff #c0ffee"), (Tokens{"hex_color #fff", "hex_color #c0ffee"}));
  EXPECT_EQ(lex("#ffff"), (Tokens{"hex_color #ffff !malformed_color"}));
  EXPECT_EQ(lex("#declare"), (Tokens{"kw_let #declare !foreign_spelling"}));
  EXPECT_EQ(lex("# note"), (Tokens{"comment # note !foreign_spelling"}));
}

// A flaw keeps the kind that was meant, so that one mistake is one error.
TEST(Lexer, ABrokenTokenIsTheTokenThatWasMeant) {
  EXPECT_EQ(lex("&&"), (Tokens{"kw_and && !foreign_spelling"}));
  EXPECT_EQ(lex("!="), (Tokens{"not_equal !="}));
  EXPECT_EQ(lex("! ="), (Tokens{"kw_not ! !foreign_spelling", "equal ="}));
  EXPECT_EQ(lex("\xe2\x89\xa4"), (Tokens{"less_equal \xe2\x89\xa4 !look_alike"}));
  EXPECT_EQ(lex("\xe2\x80\x9c"
                "a\xe2\x80\x9d"),
            (Tokens{"string \xe2\x80\x9c"
                    "a\xe2\x80\x9d !wrong_quotes"}));
  EXPECT_EQ(lex("gr\xc3\xb6\xc3\x9f"
                "e"),
            (Tokens{"name gr\xc3\xb6\xc3\x9f"
                    "e !non_ascii_name"}));
  EXPECT_EQ(lex("@"), (Tokens{"skip @ !unexpected_character"}));
}

TEST(Lexer, KnowsWhereLinesBegin) {
  Lexer lexer("a\nb\n\nc d");
  EXPECT_FALSE(lexer.next().newline_before);
  const Token b = lexer.next();
  EXPECT_TRUE(b.newline_before);
  EXPECT_FALSE(b.blank_line_before);
  EXPECT_TRUE(lexer.next().blank_line_before);
  EXPECT_FALSE(lexer.next().newline_before);
  EXPECT_EQ(lexer.next().kind, TokenKind::end);
  EXPECT_EQ(lexer.next().kind, TokenKind::end);
}

}  // namespace
}  // namespace alhazen::parser
