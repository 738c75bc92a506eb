#include "parser/lex/literal.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace alhazen::parser {
namespace {

using Limits = std::numeric_limits<double>;

TEST(Literal, NumbersAreTheNearestDoubles) {
  EXPECT_EQ(read_number("0.1").value, 0.1);
  EXPECT_EQ(read_number(".5").value, 0.5);
  EXPECT_EQ(read_number("40deg").value, 40.0);
  EXPECT_EQ(read_number("1.5e-3rad").value, 0.0015);
  EXPECT_EQ(read_number("9007199254740993").value, 9007199254740992.0);  // ties to even
  EXPECT_EQ(read_number("1.7976931348623157e308").value, Limits::max());
  EXPECT_EQ(read_number("2.2250738585072014e-308").value, Limits::min());
  EXPECT_EQ(read_number("5e-324").value, Limits::denorm_min());
  EXPECT_EQ(read_number("0").value, 0.0);
  EXPECT_EQ(read_number("0.000e999").value, 0.0);
}

TEST(Literal, NumbersOutOfRangeSayWhichEnd) {
  const auto state = [](std::string_view text) { return read_number(text).state; };
  EXPECT_EQ(state("1e400"), NumberState::too_large);
  EXPECT_EQ(state("1.7976931348623159e308"), NumberState::too_large);
  EXPECT_EQ(state("1e99999999999999999999"), NumberState::too_large);
  EXPECT_EQ(state(std::string(400, '9')), NumberState::too_large);
  EXPECT_EQ(state("1e-400"), NumberState::too_small);
  EXPECT_EQ(state("2e-324"), NumberState::too_small);  // below half of the smallest
  EXPECT_EQ(state("1e-99999999999999999999deg"), NumberState::too_small);
  EXPECT_EQ(state("." + std::string(400, '0') + "1"), NumberState::too_small);
  EXPECT_EQ(state("0." + std::string(400, '0') + "1e401"), NumberState::good);
  EXPECT_EQ(state("1" + std::string(400, '0') + "e-400"), NumberState::good);
}

TEST(Literal, StringsResolveEscapes) {
  EXPECT_EQ(read_string(R"("")"), "");
  EXPECT_EQ(read_string(R"("a\"b\\c\nd\te")"), "a\"b\\c\nd\te");
  EXPECT_EQ(read_string("\"\xc3\xb6\""), "\xc3\xb6");
}

TEST(Literal, ShortColoursRepeatTheirDigits) {
  EXPECT_EQ(read_hex_color("#c0FFee"), (std::array<int, 3>{0xC0, 0xFF, 0xEE}));
  EXPECT_EQ(read_hex_color("#1aF"), (std::array<int, 3>{0x11, 0xAA, 0xFF}));
}

}  // namespace
}  // namespace alhazen::parser
