// render/wave: the stage that finds what rays meet, where nothing is clear.
#include "render/wave/first_hits.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// Splits the generation into hits, sorted into the lists of their surface's kind, and escaped rays.
template <class Real>
void find_closest_hits(Wave<Real>& wave) {
  using L = Packet<Real>;
  for_lanes<L>(wave.rays.size(), [&](const Entries<L>& at) {
    const HitLanes<L> hits = first_hits(wave, at);
    wave.hits.append(at.index(), hits, at.active() && hits.found);
    wave.escaped.append(at.index(), at.active() && !hits.found);
  });
  wave.sort_hits();
}

template struct StagesOf<StageHome::hits>;

}  // namespace alhazen::render
