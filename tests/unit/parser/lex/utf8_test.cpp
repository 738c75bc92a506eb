#include "parser/lex/utf8.h"

#include <gtest/gtest.h>
#include <string>

namespace alhazen::parser {
namespace {

// The encoding of RFC 3629, written from its table.
std::string encode(char32_t code) {
  const auto value = static_cast<std::uint32_t>(code);
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(bits); };
  const auto tail = [&](std::uint32_t shift) { return byte(0x80U | ((value >> shift) & 0x3FU)); };
  if (value < 0x80) return {byte(value)};
  if (value < 0x800) return {byte(0xC0U | (value >> 6U)), tail(0)};
  if (value < 0x10000) return {byte(0xE0U | (value >> 12U)), tail(6), tail(0)};
  return {byte(0xF0U | (value >> 18U)), tail(12), tail(6), tail(0)};
}

TEST(Utf8, EveryCodePointAndNoSurrogate) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    const std::string text = encode(code);
    const CodePoint read = decode_utf8(text + "x");
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    ASSERT_EQ(read.valid, !surrogate) << static_cast<std::uint32_t>(code);
    if (surrogate) continue;
    ASSERT_EQ(read.value, code);
    ASSERT_EQ(read.length, text.size());
    if (text.size() > 1) {
      ASSERT_FALSE(decode_utf8(text.substr(0, text.size() - 1)).valid);
    }
  }
}

TEST(Utf8, RejectsOverlongFormsAndStrayBytes) {
  for (const char* text : {"\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\x80",
                           "\xBF", "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF", "\xC3x"}) {
    EXPECT_FALSE(decode_utf8(text).valid) << text;
  }
}

}  // namespace
}  // namespace alhazen::parser
