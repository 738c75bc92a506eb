#include "app/study/reference.h"

#include <cmath>

#include "core/math/random.h"

namespace alhazen {

double Reference::own_error() const {
  return std::hypot(sampling_error, truncation_error);
}

RgbPicture mean_of(const RgbPicture& a, const RgbPicture& b) {
  RgbPicture mean = a;
  for (std::size_t i = 0; i < mean.rgb.size(); ++i)
    mean.rgb[i] = 0.5 * (a.rgb[i] + b.rgb[i]);
  return mean;
}

double error_of_mean(const RgbPicture& a, const RgbPicture& b) {
  return 0.5 * rmse_of(a, b);
}

std::uint64_t half_seed(std::uint64_t seed, int half) {
  constexpr std::uint64_t kReferenceDimension = 0x5245464552454e43;  // "REFERENC"
  return mix_64(mix_64(seed, kReferenceDimension), static_cast<std::uint64_t>(half)) %
         static_cast<std::uint64_t>(kMaxSeed);
}

}  // namespace alhazen
