#include "app/study/truncation_ladder.h"

#include <algorithm>

#include "core/scene/settings.h"

namespace alhazen {
namespace {

// Weights of float pictures end near here: a double has long lost them in its sums.
constexpr double kSmallestCutoff = 1e-9;

}  // namespace

TruncationRung next_rung(const TruncationRung& rung) {
  return {std::min(2 * std::max(rung.max_depth, 1), kMaxDepth), rung.cutoff / 8};
}

Result<Truncation> climb(const TruncationRung& first, const LadderLimits& limits,
                         const RungRenderer& render) {
  Result<RungPicture> made = render(first);
  if (!made) return made.error();
  RungPicture here = std::move(made).value();
  Truncation truncation{first, 0, here.seconds};
  double growth = 1;  // of the seconds, from rung to rung
  for (;;) {
    const TruncationRung next = next_rung(truncation.rung);
    const bool is_step = truncation.error == 0 || here.seconds * growth <= limits.max_seconds;
    if (!is_step || next.cutoff < kSmallestCutoff) return truncation;
    made = render(next);
    if (!made) return made.error();
    RungPicture there = std::move(made).value();
    const double change = rmse_of(there.picture, here.picture);
    growth = std::max(1.0, there.seconds / std::max(here.seconds, 1e-6));
    truncation = {next, change, there.seconds};
    here = std::move(there);
    if (change <= limits.error) return truncation;
  }
}

}  // namespace alhazen
