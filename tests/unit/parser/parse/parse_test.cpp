#include "parser/parse/parse.h"

#include <gtest/gtest.h>

#include "core/diag/render_text.h"
#include "parser/ast/dump.h"

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

TEST(Parse, LongChainsAndDeepNestingAreLimits) {
  std::string chain = "let a = 1";
  for (int i = 0; i < 1'000'000; ++i)
    chain += " + a";
  const Parsed parsed = parse_text("#scn 1\n" + chain);
  EXPECT_EQ(parsed.sink.error_count(), 1U);
  EXPECT_EQ(parsed.sink.code(), ErrorCode::limit);
  const Parsed nested = parse_text("#scn 1\nlet a = " + std::string(1'000'000, '(') + "1" +
                                   std::string(1'000'000, ')'));
  EXPECT_EQ(nested.sink.error_count(), 1U);
  EXPECT_EQ(nested.sink.code(), ErrorCode::limit);
}

}  // namespace
}  // namespace alhazen::parser
