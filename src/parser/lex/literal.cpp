#include "parser/lex/literal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace alhazen::parser {
namespace {

// Whether the digits before the exponent are all 0.
bool is_written_zero(std::string_view text) {
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  return digits.find_first_of("123456789") == std::string_view::npos;
}

// Whether a number out of range is so for being small, which std::from_chars does not tell: whether
// its first significant digit stands for less than 1.
bool is_below_one(std::string_view text) {
  const std::size_t mantissa_end = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, mantissa_end);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  // A digit before the point stands for 10^(point - 1 - first), one after it for 10^(point -
  // first).
  const auto place =
      static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) - (first < point ? 1 : 0);
  if (mantissa_end == text.size()) return place < 0;
  std::string_view exponent = text.substr(mantissa_end + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int64_t written = 0;
  const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), written);
  if (read.ec == std::errc::result_out_of_range) return exponent.starts_with('-');
  return written < -place;
}

}  // namespace

Number read_number(std::string_view text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool in_range = read.ec == std::errc() && value != 0 && std::isfinite(value);
  if (in_range) return {value, NumberState::good};
  if (is_written_zero(text)) return {};
  return {0, is_below_one(text) ? NumberState::too_small : NumberState::too_large};
}

std::string read_string(std::string_view text) {
  std::string value;
  const std::string_view inside = text.substr(1, text.size() - 2);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (inside[i] != '\\') {
      value += inside[i];
      continue;
    }
    const char escaped = inside[++i];
    value += escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped;
  }
  return value;
}

std::array<int, 3> read_hex_color(std::string_view text) {
  const std::string_view digits = text.substr(1);
  const std::size_t width = digits.size() / 3;
  std::array<int, 3> color{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view part = digits.substr(i * width, width);
    std::from_chars(part.data(), part.data() + part.size(), color[i], 16);
    if (width == 1) color[i] *= 0x11;
  }
  return color;
}

}  // namespace alhazen::parser
