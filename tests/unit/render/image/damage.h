// tests/image: one good file, many bad ones.
#pragma once

#include <gtest/gtest.h>
#include <string>

namespace alhazen::render {

// Calls `decode` with the first n/16 of `bytes` for each n below 16; each must be an error with a
// message. Then with every bit of one byte in `stride` flipped, where success or an error are both
// right: what must not happen is a crash, a sanitizer finding, or a word on stdout or stderr.
template <class Decode>
void expect_damage_is_survived(const std::string& bytes, std::size_t stride, Decode decode) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  for (std::size_t n = 0; n < 16; ++n) {
    const auto result = decode(std::string_view(bytes).substr(0, bytes.size() * n / 16));
    ASSERT_FALSE(result) << n << "/16 of the file was accepted";
    EXPECT_FALSE(result.error().message.empty());
  }
  std::size_t refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += stride) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = bytes;
      flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
      if (!decode(flipped)) ++refused;
    }
  }
  EXPECT_GT(refused, 0u);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace alhazen::render
