// Values of expressions: operators by their types, access, scoping, functions.
#include <gtest/gtest.h>

#include "support.h"

namespace alhazen::parser {
namespace {

struct Case {
  const char* expression;
  const char* value;
};

TEST(Expression, OperatorsByType) {
  const Case cases[] = {
      {"1 + 2 * 3", "7"},
      {"2 - 3 - 4", "-5"},
      {"2 ^ 3 ^ 2", "512"},
      {"-2 ^ 2", "-4"},
      {"2 ^ -2", "0.25"},
      {"(-2) ^ 3", "-8"},
      {"7 % 3", "1"},
      {"-7 % 3", "2"},
      {"7 % -3", "-2"},
      {"-30deg % 360deg", "330deg"},
      {"30deg + 15deg", "45deg"},
      {"30deg * 2", "60deg"},
      {"2 * 30deg", "60deg"},
      {"90deg / 2", "45deg"},
      {"90deg / 30deg", "3"},
      {"-(30deg)", "-30deg"},
      {"<1, 2, 3> + <1, 1, 1>", "<2, 3, 4>"},
      {"<1, 2, 3> * 2", "<2, 4, 6>"},
      {"2 * <1, 2, 3>", "<2, 4, 6>"},
      {"<1, 2, 3> * <2, 3, 4>", "<2, 6, 12>"},
      {"<8, 6, 4> / 2", "<4, 3, 2>"},
      {"<8, 6, 4> / <2, 3, 4>", "<4, 2, 1>"},
      {"-<1, 2, 3>", "<-1, -2, -3>"},
      {"<1, 2> + <3, 4>", "<4, 6>"},
      {"y * 30deg", "<0deg, 30deg, 0deg>"},
      {"<0, 30deg, 0> + y * 15deg", "<0deg, 45deg, 0deg>"},
      {"rgb(0.5) * 2", "rgb(1, 1, 1)"},
      {"rgb(1, 2, 3) * rgb(2)", "rgb(2, 4, 6)"},
      {"rgb(1) + rgb(0, 1, 2)", "rgb(1, 2, 3)"},
      {"\"a\" + \"b\"", "ab"},
      {"[1, 2] + [3]", "[1, 2, 3]"},
      {"1 < 2", "true"},
      {"2 <= 2", "true"},
      {"30deg > 40deg", "false"},
      {"\"a\" < \"b\"", "true"},
      {"[1, [2]] == [1, [2]]", "true"},
      {"x == <1, 0, 0>", "true"},
      {"rgb(1) != rgb(2)", "true"},
      {"true and not false", "true"},
      {"if 1 < 2 then \"yes\" else \"no\"", "yes"},
  };
  for (const Case& c : cases)
    EXPECT_EQ(value_of(c.expression), c.value) << c.expression;
}

TEST(Expression, LogicDoesNotEvaluateWhatCannotMatter) {
  EXPECT_EQ(value_of("false and 1 / 0 == 1"), "false");
  EXPECT_EQ(value_of("true or 1 / 0 == 1"), "true");
  EXPECT_EQ(value_of("if true then 1 else 1 / 0"), "1");
}

// Every pair of types under every operator is either a value or an error at an operand; nothing
// comes out that is neither.
TEST(Expression, EveryPairOfTypesIsDecided) {
  const char* values[] = {"2",         "20deg",
                          "true",      "\"s\"",
                          "<1, 2>",    "<1, 2, 3>",
                          "y*2deg",    "rgb(0.5)",
                          "[1, 2]",    "0 .. 3",
                          "glass { }", "sphere { }",
                          "cos",       "checker(rgb(0), rgb(1))",
                          "phong { }", "about(y, 1deg)"};
  for (const char* op : {"+", "-", "*", "/", "%", "^", "<", "==", "and"}) {
    for (const char* left : values) {
      for (const char* right : values) {
        Evaluated e;
        const std::string text = std::string("(") + left + ") " + op + " (" + right + ")";
        evaluate_into(e, kCamera + ("print " + text));
        EXPECT_EQ(e.result.printed.size() + e.sink.error_count(), 1U) << text << e.diagnostics();
      }
    }
  }
}

TEST(Expression, MembersAndElements) {
  EXPECT_EQ(value_of("<1, 2, 3>.z"), "3");
  EXPECT_EQ(value_of("<1, 2>.y"), "2");
  EXPECT_EQ(value_of("(y*30deg).y"), "30deg");
  EXPECT_EQ(value_of("rgb(1, 2, 3).g"), "2");
  EXPECT_EQ(value_of("[1, [2, 3]][1][0]"), "2");
  EXPECT_EQ(value_of("(10 .. 20 by 5)[1]"), "15");
}

TEST(Expression, RangesHaveTheEndsTheySay) {
  EXPECT_EQ(value_of("list(0 .. 3)"), "[0, 1, 2]");
  EXPECT_EQ(value_of("list(0 ..= 3)"), "[0, 1, 2, 3]");
  EXPECT_EQ(value_of("list(3 .. 0 by -1)"), "[3, 2, 1]");
  EXPECT_EQ(value_of("list(3 .. 0)"), "[]");
  EXPECT_EQ(value_of("list(0deg .. 90deg by 30deg)"), "[0deg, 30deg, 60deg]");
  // 0.1 * 10 is exactly 1 in double: ten values before it, eleven with it.
  EXPECT_EQ(value_of("len(0 .. 1 by 0.1)"), "10");
  EXPECT_EQ(value_of("len(0 ..= 1 by 0.1)"), "11");
}

TEST(Expression, LongChainsTakeNoStack) {
  std::string sum = "0";
  for (int i = 0; i < 900; ++i)
    sum += "+1";
  EXPECT_EQ(value_of(sum), "900");
}

std::string printed(const std::string& text) {
  Evaluated e;
  evaluate_into(e, kCamera + text);
  return e.result.printed.empty() ? e.diagnostics() : e.result.printed.back().text;
}

TEST(Scope, NamesAreLexical) {
  EXPECT_EQ(printed("let a = 1\nfn f() = a\nfn g(a) = f()\nprint g(2)"), "1");
  EXPECT_EQ(printed("let a = 1\ngroup { let a = 2\nprint a }"), "2");
  EXPECT_EQ(printed("let sqrt = 3\nprint sqrt"), "3");
  EXPECT_EQ(printed("fn even(n) = if n == 0 then true else odd(n - 1)\n"
                    "fn odd(n) = if n == 0 then false else even(n - 1)\nprint even(10)"),
            "true");
}

TEST(Scope, FunctionsAreValues) {
  EXPECT_EQ(printed("fn twice(f, a) = f(f(a))\nfn inc(n) = n + 1\nprint twice(inc, 3)"), "5");
  EXPECT_EQ(printed("fn adder(n) { fn add(m) = n + m\nreturn add }\nprint adder(2)(3)"), "5");
  EXPECT_EQ(printed("fn f(a, b = a * 2) = a + b\nprint f(1), f(1, 1), f(b: 5, a: 1)"), "3 2 6");
  EXPECT_EQ(printed("fn fib(n) = if n < 2 then n else fib(n - 1) + fib(n - 2)\nprint fib(15)"),
            "610");
  EXPECT_EQ(
      printed("fn first_above(limit) { for i in 0 .. 100 { if i * i > limit { return i } } }\n"
              "print first_above(50)"),
      "8");
}

}  // namespace
}  // namespace alhazen::parser
