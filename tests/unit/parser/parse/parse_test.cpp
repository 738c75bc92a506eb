#include "parser/parse/parse.h"

#include <gtest/gtest.h>

#include "core/diag/render_text.h"
#include "parser/ast/dump.h"
#include "parser/print/format.h"

namespace alhazen::parser {
namespace {

struct Parsed {
  SourceManager sources;
  DiagnosticSink sink;
  ast::File tree;
  std::string errors() const { return render_text(sink, sources); }
};

Parsed parse_text(std::string text) {
  Parsed parsed;
  const FileId file = parsed.sources.add("t.scn", std::move(text));
  parsed.tree = parse(file, parsed.sources, parsed.sink);
  return parsed;
}

std::string tree_of(const std::string& items) {
  const Parsed parsed = parse_text("#scn 1\n" + items);
  EXPECT_EQ(parsed.errors(), "");
  return ast::dump(parsed.tree);
}

TEST(Parse, Precedence) {
  EXPECT_EQ(tree_of("let a = -x ^ -y * 2 + 1 < 3 and not b or c"),
            R"(file, version 1
  let a
    or
      and
        <
          +
            *
              -
                ^
                  name x
                  -
                    name y
              number 2
            number 1
          number 3
        not
          name b
      name c
)");
}

TEST(Parse, PlacementAndPropertyDifferByWhiteSpace) {
  EXPECT_EQ(tree_of("tower(3, height: 2,) { translate x } radius (3) * 2"),
            R"(file, version 1
  placement
    object
      call
        name tower
        number 3
        argument height
          number 2
      body
        property translate
          name x
  property radius
    *
      parentheses
        number 3
      number 2
)");
}

TEST(Parse, TheSketchOfTheDesign) {
  const Parsed parsed = parse_text(R"(#scn 1
param ball_ior = 1.5 in 1.0 .. 3.0 "index of refraction of the ball"

camera perspective { position <0, 1.5, -6>  look_at <0, 1, 0>  fov 40deg }
light point { position <5, 8, -5>  intensity rgb(60) }          // falls off

let ball = glass { ior ball_ior  absorption rgb(0.1, 0.02, 0.02) }
plane  { normal y  material diffuse { color checker(rgb(0.9), rgb(0.1)) } }
for i in 0 .. 12 {
  sphere { center <3*cos(i*30deg), 0.3, 3*sin(i*30deg)>  radius 0.3 }
}
if a == b { x 1 } else if c { y 2 } else { z 3 }
fn tower(n, height = 2) { sphere { radius if n > 1 then 2 else 3 } }
)");
  EXPECT_EQ(parsed.errors(), "");
  EXPECT_EQ(parsed.tree.items.size(), 8U);
}

std::string repeated(int count, const std::string& text) {
  std::string out;
  for (int i = 0; i < count; ++i)
    out += text;
  return out;
}

// Each of these would be a tree 200,000 levels high, too much for a stack of 8 MiB.
TEST(Parse, LongChainsAndDeepNestingAreLimits) {
  constexpr int kMany = 200'000;
  const std::string texts[] = {
      "let a = 1" + repeated(kMany, " + a"),
      "let a = 1" + repeated(kMany, "[1]"),
      "let a = f" + repeated(kMany, "()"),
      "let a = b" + repeated(kMany, ".c"),
      "let a = " + repeated(kMany, "-") + "1",
      "let a = " + repeated(kMany, "not ") + "b",
      "let a = 1" + repeated(kMany, "^1"),
      "let a = " + repeated(kMany, "(") + "1" + repeated(kMany, ")"),
      "let a = " + repeated(kMany, "[") + repeated(kMany, "]"),
      "let a = " + repeated(kMany, "<1, ") + "2" + repeated(kMany, ">"),
      "let a = " + repeated(kMany, "if b then 1 else ") + "2",
      "if a { } " + repeated(kMany, "else if b { } "),
      repeated(kMany, "group { ") + repeated(kMany, "}"),
      "let a = " + repeated(kMany, "b { c ") + "1" + repeated(kMany, "}"),
  };
  for (const std::string& text : texts) {
    const Parsed parsed = parse_text("#scn 1\n" + text);
    EXPECT_EQ(parsed.sink.error_count(), 1U) << parsed.errors();
    EXPECT_EQ(parsed.sink.code(), ErrorCode::limit) << text.substr(0, 40);
  }
}

// The highest trees the limits let through are walked and destroyed within an ordinary stack.
TEST(Parse, TreesAtTheLimitsAreSafeToWalk) {
  std::string nested;
  for (int i = 0; i < 190; ++i)
    nested += "[1 + ";
  nested += "1";
  for (int i = 0; i < 190; ++i)
    nested += " + 1 + 1]";
  std::string chain = "1";
  for (int i = 0; i < 998; ++i)
    chain += " - 1";
  std::string bodies;
  for (int i = 0; i < 190; ++i)
    bodies += "if a { ";
  bodies += std::string(190, '}');
  const Parsed parsed =
      parse_text("#scn 1\nlet a = " + nested + "\nlet b = " + chain + "\n" + bodies);
  EXPECT_EQ(parsed.errors(), "");
  EXPECT_GT(ast::dump(parsed.tree).size(), 10'000U);
  EXPECT_GT(format(parsed.tree, parsed.sources).size(), 1'000U);
}

TEST(Parse, CommentsHangOnTheirItems) {
  const Parsed parsed = parse_text(R"(#scn 1 // header
// leading

let a = [1, /* interior */ 2] // trailing
sphere { // first
  radius 1
  // dangling
} // closing
// last
)");
  EXPECT_EQ(parsed.errors(), "");
  EXPECT_EQ(ast::dump(parsed.tree, {false, true}), R"(file, version 1
  header comment "// header"
  let a
    list
      number 1
      number 2
    leading comment "// leading"
    interior comment "/* interior */"
    trailing comment "// trailing"
  property sphere
    body
      property radius
        number 1
        leading comment "// first"
      dangling comment "// dangling"
    trailing comment "// closing"
  dangling comment "// last"
)");
  EXPECT_TRUE(parsed.tree.items[0]->blank_line_before);
  EXPECT_FALSE(parsed.tree.items[1]->blank_line_before);
}

TEST(Parse, SpansAreThoseOfTheText) {
  const Parsed parsed = parse_text("#scn 1\nlet a = f(1, b: <2, 3>) + c.d\n");
  const auto& let = std::get<ast::Let>(parsed.tree.items[0]->node);
  EXPECT_EQ(parsed.sources.text(parsed.tree.items[0]->span), "let a = f(1, b: <2, 3>) + c.d");
  EXPECT_EQ(parsed.sources.text(let.name.span), "a");
  const auto& sum = std::get<ast::Binary>(let.value->node);
  EXPECT_EQ(parsed.sources.text(sum.op_span), "+");
  EXPECT_EQ(parsed.sources.text(sum.left->span), "f(1, b: <2, 3>)");
  EXPECT_EQ(parsed.sources.text(sum.right->span), "c.d");
  const auto& call = std::get<ast::Call>(sum.left->node);
  EXPECT_EQ(parsed.sources.text(call.arguments_span), "(1, b: <2, 3>)");
  EXPECT_EQ(parsed.sources.text(call.arguments[1].value->span), "<2, 3>");
}

TEST(Parse, AByteOrderMarkIsSkipped) {
  EXPECT_EQ(parse_text("\xEF\xBB\xBF#scn 1\nlet a = 1").errors(), "");
}

TEST(Parse, StopsLookingAfterTheLimitOfErrors) {
  std::string text = "#scn 1\n";
  for (int i = 0; i < 100'000; ++i)
    text += "let = )\n@\n";
  const Parsed parsed = parse_text(text);
  EXPECT_EQ(parsed.sink.error_count(), 20U);
  EXPECT_TRUE(parsed.sink.truncated());
}

}  // namespace
}  // namespace alhazen::parser
