// render/wave: directional lights, on each kind of surface.
#include "render/wave/lit_surfaces.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real, template <class> class Response>
void shine_directionals(Wave<Real>& wave) {
  using L = Wide<Real>;
  for (const auto& light : wave.world.lights.directionals) {
    shine<Real, Response>(wave, light,
                          [&](const Entries<L>&) { return light.kernel.template sample<L>(); });
  }
}

template struct StagesOf<StageHome::directional>;

}  // namespace alhazen::render
