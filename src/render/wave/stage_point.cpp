// render/wave: point lights, on each kind of surface.
#include "render/wave/lit_surfaces.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real, template <class> class Response>
void shine_points(Wave<Real>& wave) {
  using L = Wide<Real>;
  for (const auto& light : wave.world.lights.points) {
    shine<Real, Response>(wave, light, [&](const Entries<L>& hits) {
      return light.kernel.template sample<L>(hits.of(wave.hits.position));
    });
  }
}

template struct StagesOf<StageHome::point>;

}  // namespace alhazen::render
