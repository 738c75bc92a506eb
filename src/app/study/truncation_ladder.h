// app/study: how deep, and down to which weight, the reference follows its rays.
#pragma once

#include <functional>
#include <vector>

#include "app/study/picture_errors.h"
#include "core/base/result.h"

namespace alhazen {

struct TruncationRung {
  int max_depth = 0;
  double cutoff = 0;
};

// A picture at that rung, always of the same samples, and what it took.
struct RungPicture {
  RgbPicture picture;
  double seconds = 0;
};
using RungRenderer = std::function<Result<RungPicture>(const TruncationRung&)>;

struct Truncation {
  TruncationRung rung;
  double error = 0;    // RMSE, estimated: the change that the last step made
  double seconds = 0;  // of a picture there
};

struct LadderLimits {
  double error = 1e-6;       // no need to go on when a step changes less
  double max_seconds = 1e9;  // nor when the next rung would take more than that
};

// Twice the depth and an eighth of the cutoff: both errors fall geometrically along such steps, so
// the last change is larger than all the steps that are not taken would make together.
TruncationRung next_rung(const TruncationRung& rung);

// Climbs from `first`, which is taken as it is.
Result<Truncation> climb(const TruncationRung& first, const LadderLimits& limits,
                         const RungRenderer& render);

}  // namespace alhazen
