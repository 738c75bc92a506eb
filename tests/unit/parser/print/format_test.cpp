#include "parser/print/format.h"

#include <gtest/gtest.h>
#include <string>

#include "parser/ast/dump.h"
#include "support/front_end.h"

namespace alhazen::parser {
namespace {

// The items of `text` in canonical layout; formatting them again changes nothing.
std::string formatted(const std::string& text) {
  const test::FrontEnd first = test::front_end("f.scn", "#scn 1\n" + text);
  EXPECT_EQ(first.errors(), "");
  const std::string once = format(first.tree, first.sources);
  const test::FrontEnd second = test::front_end("f.scn", once);
  EXPECT_EQ(format(second.tree, second.sources), once);
  EXPECT_EQ(ast::dump(first.tree), ast::dump(second.tree));
  EXPECT_TRUE(once.starts_with("#scn 1\n"));
  return once.substr(7);
}

TEST(Format, OneLineStaysOneLine) {
  EXPECT_EQ(formatted("sphere{center <0,1 ,0>radius 1}"),
            "sphere { center <0, 1, 0>  radius 1 }\n");
  EXPECT_EQ(formatted("group {  }"), "group {}\n");
  EXPECT_EQ(formatted("if a {b 1} else {c 2}"), "if a { b 1 } else { c 2 }\n");
}

TEST(Format, WhatTheAuthorBrokeStaysBroken) {
  EXPECT_EQ(formatted("sphere {\nradius 1 center <0,1,0> }"),
            "sphere {\n  radius 1\n  center <0, 1, 0>\n}\n");
  EXPECT_EQ(formatted("let a = [\n1,2 ]"), "let a = [\n  1,\n  2,\n]\n");
  EXPECT_EQ(formatted("let a = f(\n1, b:2)"), "let a = f(\n  1,\n  b: 2,\n)\n");
  EXPECT_EQ(formatted("if a {\n b 1 } else { c 2 }"), "if a {\n  b 1\n} else {\n  c 2\n}\n");
}

TEST(Format, WhatDoesNotFitIsBroken) {
  const std::string name(40, 'n');
  EXPECT_EQ(formatted("sphere { " + name + " 1 " + name + " 2 radius 3 }"),
            "sphere {\n  " + name + " 1\n  " + name + " 2\n  radius 3\n}\n");
  EXPECT_EQ(formatted("let a = " + name + " + " + name + "*2 - " + name),
            "let a = " + name + "\n    + " + name + " * 2\n    - " + name + "\n");
  // "let a = [" + 89 + "]" are the 100 columns of a line, one more is too many.
  const std::string half(43, 'n');
  EXPECT_EQ(formatted("let a = [" + half + "," + half + "n,]"),
            "let a = [" + half + ", " + half + "n]\n");
  EXPECT_EQ(formatted("let a = [" + half + "nnn," + half + "]"),
            "let a = [\n  " + half + "nnn,\n  " + half + ",\n]\n");
}

TEST(Format, LiteralsKeepTheirSpelling) {
  EXPECT_EQ(formatted("let a=[1.50,.5,1E+2,007,040.0deg,#FfF,\"a\\tb\"]"),
            "let a = [1.50, .5, 1E+2, 007, 040.0deg, #FfF, \"a\\tb\"]\n");
}

TEST(Format, Operators) {
  EXPECT_EQ(formatted("let a = -b^-2*(c+d)%3<4 and not e or f.g[1](2)"),
            "let a = -b^-2 * (c + d) % 3 < 4 and not e or f.g[1](2)\n");
  EXPECT_EQ(formatted("let a=0..10 by 2 let b=1..=3 let c=1 .x"),
            "let a = 0 .. 10 by 2\nlet b = 1 ..= 3\nlet c = 1 .x\n");
  EXPECT_EQ(formatted("param a=1 in 0..2\"text\""), "param a = 1 in 0 .. 2 \"text\"\n");
  EXPECT_EQ(formatted("fn f(a,b=2,)=if a then b else 3"), "fn f(a, b = 2) = if a then b else 3\n");
  EXPECT_EQ(formatted("tower(1){translate x} radius (3)"),
            "tower(1) { translate x }\nradius (3)\n");
}

TEST(Format, KeepsCommentsAndSingleBlankLines) {
  EXPECT_EQ(formatted("\n\n\n// a\nlet b = 1   // c\n\n\n/* d */ let e = 2\n// f\n"),
            "\n// a\nlet b = 1  // c\n\n/* d */\nlet e = 2\n// f\n");
  EXPECT_EQ(formatted("sphere { radius 1 /* why */ }"), "sphere {\n  radius 1  /* why */\n}\n");
  EXPECT_EQ(formatted("sphere { // the ball\n\n  radius 1\n\n  // end\n}"),
            "sphere {\n  // the ball\n\n  radius 1\n\n  // end\n}\n");
}

TEST(Format, AnItemWithACommentInsideStaysAsItIsOrGivesItsCommentToTheLineAbove) {
  EXPECT_EQ(formatted("let a = [1,  // one\n    2]"), "let a = [1,  // one\n    2]\n");
  EXPECT_EQ(formatted("sphere /* s */ {radius 1}"), "/* s */\nsphere { radius 1 }\n");
}

TEST(Format, EndsLinesWithALineFeed) {
  EXPECT_EQ(formatted("let a = 1\r\n/* b\r\n   c */\r\nlet d = 2\r\n"),
            "let a = 1\n/* b\n   c */\nlet d = 2\n");
}

}  // namespace
}  // namespace alhazen::parser
