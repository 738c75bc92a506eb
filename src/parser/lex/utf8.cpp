#include "parser/lex/utf8.h"

namespace alhazen::parser {

CodePoint decode_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return static_cast<unsigned char>(text[i]);
  };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {static_cast<char32_t>(lead), 1, true};

  std::uint32_t length = 0;
  std::uint32_t smallest = 0;  // anything below would be overlong
  std::uint32_t value = 0;
  if ((lead & 0xE0U) == 0xC0U) {
    length = 2, smallest = 0x80, value = lead & 0x1FU;
  } else if ((lead & 0xF0U) == 0xE0U) {
    length = 3, smallest = 0x800, value = lead & 0x0FU;
  } else if ((lead & 0xF8U) == 0xF0U) {
    length = 4, smallest = 0x10000, value = lead & 0x07U;
  } else {
    return {};
  }
  if (text.size() < length) return {};
  for (std::uint32_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    value = (value << 6U) | (byte(i) & 0x3FU);
  }
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < smallest || value > 0x10FFFF || surrogate) return {};
  return {static_cast<char32_t>(value), length, true};
}

}  // namespace alhazen::parser
