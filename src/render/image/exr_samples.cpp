#include "render/image/exr_samples.h"

#include <cmath>

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

void count_unwritable(std::span<const float> samples, SampleType type, ExrReport& report) {
  for (const float sample : samples) {
    if (!std::isfinite(sample)) {
      ++report.non_finite;
    } else if (overflows(sample, type)) {
      ++report.clamped;
    }
  }
}

}  // namespace alhazen::render
