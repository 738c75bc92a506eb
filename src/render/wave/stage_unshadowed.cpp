// render/wave: the stage of light that nothing can stop.
#include "render/wave/light_paths.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real>
void add_unshadowed(Wave<Real>& wave) {
  using L = Wide<Real>;
  const ShadowQueue<Real>& paths = wave.unshadowed;
  for_lanes<L>(paths.size(), [&](const Entries<L>& at) {
    const Entries<L> hits(at.of(paths.hit), at.active());
    const Entries<L> rays(hits.of(wave.hits.ray), at.active());
    add_arrived(wave, rays, at.active(), at.of(paths.radiance));
  });
}

template struct StagesOf<StageHome::unshadowed>;

}  // namespace alhazen::render
