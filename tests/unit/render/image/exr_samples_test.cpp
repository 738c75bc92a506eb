// The quick answer for many samples is that of writable_sample for each.
#include "render/image/exr_samples.h"

#include <array>
#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace alhazen::render {
namespace {

using Limits = std::numeric_limits<float>;

// At the limits, on both sides of them, and every sign and exponent with some mantissas.
std::vector<float> samples() {
  std::vector<float> all = {
      0.0F,          65504.0F,           65504.004F,          65520.0F,
      Limits::max(), Limits::infinity(), Limits::quiet_NaN(), Limits::denorm_min()};
  for (std::uint32_t high = 0; high < 512; ++high) {
    for (const std::uint32_t mantissa : {0U, 1U, 0x3fe000U, 0x3fffffU, 0x7fe000U, 0x7fffffU})
      all.push_back(std::bit_cast<float>(high << 23 | mantissa));
  }
  return all;
}

TEST(ExrSamples, AreWritableIfNoneOfThemWouldChange) {
  for (const SampleType type : {SampleType::half, SampleType::float32}) {
    int changed = 0;
    for (const float sample : samples()) {
      for (const float signed_sample : {sample, -sample}) {
        const bool stays = std::bit_cast<std::uint32_t>(writable_sample(signed_sample, type)) ==
                           std::bit_cast<std::uint32_t>(signed_sample);
        changed += stays ? 0 : 1;
        // Alone, and at each place among others that stay.
        EXPECT_EQ(are_writable(std::array{signed_sample}, type), stays) << signed_sample;
        std::array<float, 19> row{};
        for (float& place : row) {
          place = signed_sample;
          EXPECT_EQ(are_writable(row, type), stays) << signed_sample;
          place = 1.0F;
        }
      }
    }
    EXPECT_GT(changed, 0);
  }
  EXPECT_TRUE(are_writable({}, SampleType::half));
}

}  // namespace
}  // namespace alhazen::render
