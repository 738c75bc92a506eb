// render/wave: the stage of light that arrives or does not.
#include "render/wave/light_paths.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real>
void add_past_opaque(Wave<Real>& wave) {
  using L = Packet<Real>;
  count_shadow_rays(wave);
  for_lanes<L>(wave.light_paths.size(), [&](const Entries<L>& at) {
    const LightPaths<L> paths(wave, wave.light_paths, at);
    const MaskOf<L> blocked = any_hits(
        wave.world.tree, paths.ray, paths.from, [&](int lane) { return paths.source_of(lane); },
        paths.distance, paths.lamp, paths.active);
    add_arrived(wave, paths.rays, paths.active && !blocked, paths.radiance);
  });
}

template struct StagesOf<StageHome::shadows>;

}  // namespace alhazen::render
