// render/wave: the stages of hits on surfaces that need no coordinates.
#include "render/wave/find_surfaces.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// A pattern is met by the first of these stages only where nobody asks for its colour.
template <class Real>
void find_plain_colors(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.hits.size(), [&](const Entries<L>& at) {
    at.store(wave.world.materials.template records_of<L>(&MaterialRecord<Real>::solid_color,
                                                         at.of(wave.hits.material), at.active()),
             wave.hits.color);
  });
}

template struct StagesOf<StageHome::surfaces>;

}  // namespace alhazen::render
