// render/wave: area lights on a kind of surface.
#pragma once

#include "render/wave/area_samples.h"
#include "render/wave/lit_surfaces.h"

namespace alhazen::render {

template <class Real, template <class> class Response, template <class> class View, class Placed>
void shine_area(Wave<Real>& wave, const Placed& light) {
  using L = Packet<Real>;
  for_lanes<L>(wave.of(Response<L>::kKind), [&](const Entries<L>& hits) {
    visit_area<View>(wave, light, hits, [&](const Entries<L>& dealt, const LightSample<L>& sample) {
      queue_light<Real, Response>(wave, dealt, sample, light);
    });
  });
}

}  // namespace alhazen::render
