// render/wave: sphere lights, on each kind of surface.
#include "render/wave/area_light.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real, template <class> class Response>
void shine_spheres(Wave<Real>& wave) {
  for (const auto& light : wave.world.lights.spheres)
    shine_area<Real, Response, SphereLightView>(wave, light);
}

template struct StagesOf<StageHome::sphere>;

}  // namespace alhazen::render
