// render/wave: point lights, on each kind of surface.
#include "render/wave/place_light.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real, template <class> class Response>
void shine_points(Wave<Real>& wave) {
  shine_from_places<Real, Response>(wave, wave.world.lights.points);
}

template struct StagesOf<StageHome::point>;

}  // namespace alhazen::render
