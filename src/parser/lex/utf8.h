// parser/lex: UTF-8, read strictly: overlong forms, surrogates and numbers beyond U+10FFFF are
// invalid.
#pragma once

#include <cstdint>
#include <string_view>

namespace alhazen::parser {

struct CodePoint {
  char32_t value = 0;
  std::uint32_t length = 1;  // in bytes; 1 for an invalid byte
  bool valid = false;
};

// The first code point of `text`. Precondition: not empty.
CodePoint decode_utf8(std::string_view text);

// True of the bytes that begin or continue a code point beyond ASCII.
constexpr bool is_beyond_ascii(char byte) {
  return (static_cast<unsigned char>(byte) & 0x80U) != 0;
}

}  // namespace alhazen::parser
