#include "render/image/exr_samples.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace alhazen::render {
namespace {

bool overflows(float sample, SampleType type) {
  return type == SampleType::half && std::fabs(sample) > kLargestHalf;
}

}  // namespace

float writable_sample(float sample, SampleType type) {
  if (!std::isfinite(sample)) return 0;
  if (overflows(sample, type)) return std::copysign(kLargestHalf, sample);
  return sample;
}

// Floats without their sign are in the order of their bits, infinity and NaN last. One answer for
// all, without a branch, is a loop in lanes.
bool are_writable(std::span<const float> samples, SampleType type) {
  const float limit = type == SampleType::half ? kLargestHalf : std::numeric_limits<float>::max();
  const auto limit_bits = std::bit_cast<std::int32_t>(limit);
  std::int32_t above = 0;
  for (const float sample : samples)
    above |= limit_bits - (std::bit_cast<std::int32_t>(sample) & 0x7fffffff);
  return above >= 0;
}

void count_unwritable(std::span<const float> samples, SampleType type, ExrReport& report) {
  if (are_writable(samples, type)) return;
  for (const float sample : samples) {
    if (!std::isfinite(sample)) {
      ++report.non_finite;
    } else if (overflows(sample, type)) {
      ++report.clamped;
    }
  }
}

}  // namespace alhazen::render
