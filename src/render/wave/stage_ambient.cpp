// render/wave: ambient light, on each kind of surface.
#include "render/wave/lit_surfaces.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real, template <class> class Response>
void add_ambient(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.of(Response<L>::kKind), [&](const Entries<L>& hits) {
    const Entries<L> rays(hits.of(wave.hits.ray), hits.active());
    const L cos_view = -dot(rays.of(wave.rays.direction), hits.of(wave.hits.shading_normal));
    const MaskOf<L> seen = hits.active() && cos_view > L(0);
    if (!any(seen)) return;
    const Rgb<L> answer = Response<L>::even_sky(LitSurfaces<L>(wave, hits, seen), cos_view);
    wave.add(rays, seen, Rgb<L>(wave.world.lights.ambient) * answer);
  });
}

template struct StagesOf<StageHome::ambient>;

}  // namespace alhazen::render
