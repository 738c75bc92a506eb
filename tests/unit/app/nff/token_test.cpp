#include "app/nff/token.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace alhazen {
namespace {

std::vector<std::string> words(std::string text) {
  SourceManager sources;
  NffTokens tokens(sources.add("a.nff", std::move(text)), sources);
  std::vector<std::string> out;
  while (!tokens.peek().is_end())
    out.emplace_back(tokens.take().text);
  return out;
}

using Words = std::vector<std::string>;

TEST(NffTokens, AreSeparatedByAnyWhiteSpace) {
  EXPECT_EQ(words("s 1\t2\r\n3\n\n\f4"), (Words{"s", "1", "2", "3", "4"}));
  EXPECT_EQ(words(""), Words{});
  EXPECT_EQ(words(" \n\n"), Words{});
}

TEST(NffTokens, CommentsEndWithTheirLine) {
  EXPECT_EQ(words("# s 1\ns 2#3\n4"), (Words{"s", "2", "4"}));
  EXPECT_EQ(words("a # b\r\nc"), (Words{"a", "c"}));
  EXPECT_EQ(words("a\n# the last line, without an end"), (Words{"a"}));
  EXPECT_EQ(words("#\n#\n##\nz"), (Words{"z"}));
}

TEST(NffTokens, KnowTheirPlace) {
  SourceManager sources;
  NffTokens tokens(sources.add("a.nff", "# x\n  pp 3"), sources);
  EXPECT_EQ(sources.describe(tokens.take().span), "a.nff:2:3");
  EXPECT_EQ(tokens.take().span, (SourceSpan{0, 9, 10}));
  EXPECT_EQ(tokens.take().span, (SourceSpan{0, 10, 10}));  // the end
}

TEST(NffNumber, ReadsWhatPercentGReads) {
  const auto value = [](std::string_view text) {
    const NffNumber number = read_nff_number(text);
    EXPECT_EQ(number.state, NffNumberState::good) << text;
    return number.value;
  };
  EXPECT_EQ(value("1"), 1);
  EXPECT_EQ(value("-.5"), -0.5);
  EXPECT_EQ(value("+2."), 2);
  EXPECT_EQ(value("007.250"), 7.25);
  EXPECT_EQ(value("1e-3"), 1e-3);
  EXPECT_EQ(value("1E+3"), 1e3);
  EXPECT_EQ(value("0.1"), 0.1);
  EXPECT_EQ(value("1e100"), 1e100);
}

TEST(NffNumber, WhatIsTooSmallIsZeroWithoutASign) {
  for (const std::string_view text : {"-0", "-0.0", "1e-320", "-1e-320", "1e-9999", "-1e-9999"}) {
    const NffNumber number = read_nff_number(text);
    EXPECT_EQ(number.state, NffNumberState::good) << text;
    EXPECT_EQ(number.value, 0) << text;
    EXPECT_FALSE(std::signbit(number.value)) << text;
  }
}

TEST(NffNumber, RefusesTheRest) {
  for (const std::string_view text : {"", "s", ".", "-", "+-1", "e5", "1e", "1e+", "inf", "-inf",
                                      "nan", "0x10", "1,5", "1d3", "1.2.3", "1f", "--1"}) {
    EXPECT_EQ(read_nff_number(text).state, NffNumberState::not_a_number) << text;
  }
  for (const std::string_view text : {"1e101", "-1e400", "1e99999999999999999999"}) {
    EXPECT_EQ(read_nff_number(text).state, NffNumberState::too_large) << text;
  }
}

}  // namespace
}  // namespace alhazen
