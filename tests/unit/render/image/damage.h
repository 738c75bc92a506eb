// tests/render: one good file, many bad ones. What must never happen is a crash, a sanitizer
// finding, or a word on stdout or stderr.
#pragma once

#include <gtest/gtest.h>
#include <string>
#include <string_view>

namespace alhazen::render {

class ExpectSilence {
 public:
  ExpectSilence() {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
  }
  ExpectSilence(const ExpectSilence&) = delete;
  ExpectSilence& operator=(const ExpectSilence&) = delete;
  ~ExpectSilence() {
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
};

// How many of the first n/16 of `bytes`, n below 16, are refused with a message.
template <class Decode>
int refused_truncations(const std::string& bytes, Decode decode) {
  const ExpectSilence silence;
  int refused = 0;
  for (std::size_t n = 0; n < 16; ++n) {
    const auto result = decode(std::string_view(bytes).substr(0, bytes.size() * n / 16));
    if (!result && !result.error().message.empty()) ++refused;
  }
  return refused;
}

// How many of the copies with one bit flipped, in every byte at a multiple of `stride`, are
// refused. Some flips do no harm, so only that some are refused can be demanded.
template <class Decode>
int refused_flips(const std::string& bytes, std::size_t stride, Decode decode) {
  const ExpectSilence silence;
  int refused = 0;
  for (std::size_t i = 0; i < bytes.size(); i += stride) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = bytes;
      flipped[i] = static_cast<char>(flipped[i] ^ (1 << bit));
      if (!decode(flipped)) ++refused;
    }
  }
  return refused;
}

template <class Decode>
void expect_damage_is_survived(const std::string& bytes, std::size_t stride, Decode decode) {
  EXPECT_EQ(refused_truncations(bytes, decode), 16);
  EXPECT_GT(refused_flips(bytes, stride, decode), 0);
}

}  // namespace alhazen::render
