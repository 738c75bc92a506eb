// app/study: the converged picture that errors are measured against, and how far it can be trusted.
#pragma once

#include "app/study/picture_errors.h"
#include "app/study/setting.h"

namespace alhazen {

// An error that is less than this many times the reference's own is not shown.
inline constexpr double kReferenceMargin = 10;

struct Reference {
  RgbPicture picture;
  RenderSettings settings;      // samples: of both halves together
  double sampling_error = 0;    // estimated, RMSE
  double truncation_error = 0;  // of its depth and cutoff, estimated, RMSE

  double own_error() const;
  // The smallest error that can be shown against it.
  double floor() const { return kReferenceMargin * own_error(); }
};

// The mean of two pictures of independent samples.
RgbPicture mean_of(const RgbPicture& a, const RgbPicture& b);

// The RMSE of that mean. Each half has its error e; they differ by sqrt(2) e, their mean is off by
// e / sqrt(2): half of the difference.
double error_of_mean(const RgbPicture& a, const RgbPicture& b);

// Seeds of the halves: never those of a picture that is studied.
std::uint64_t half_seed(std::uint64_t seed, int half);

}  // namespace alhazen
