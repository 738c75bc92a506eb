// render/wave: rectangle lights, on each kind of surface.
#include "render/wave/area_light.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real, template <class> class Response>
void shine_rectangles(Wave<Real>& wave) {
  for (const auto& light : wave.world.lights.rectangles)
    shine_area<Real, Response, RectangleLightView>(wave, light);
}

template struct StagesOf<StageHome::rectangle>;

}  // namespace alhazen::render
