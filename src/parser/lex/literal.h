// parser/lex: the values of literals.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace alhazen::parser {

enum class NumberState { good, too_large, too_small };

struct Number {
  double value = 0;
  NumberState state = NumberState::good;
};

// The double nearest to a NUMBER or ANGLE, of which the unit is not looked at. Precondition: the
// text of a token without a flaw (or with one of magnitude, which `state` tells).
Number read_number(std::string_view text);

// Of a STRING without a flaw, quotation marks included: its value, escapes resolved.
std::string read_string(std::string_view text);

// Of a HEX_COLOR without a flaw: red, green, blue from 0 to 255; `#abc` is `#aabbcc`.
std::array<int, 3> read_hex_color(std::string_view text);

}  // namespace alhazen::parser
