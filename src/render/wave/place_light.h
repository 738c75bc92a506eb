// render/wave: lights that shine from one place, as points and spots, on a kind of surface.
#pragma once

#include "render/wave/lit_surfaces.h"

namespace alhazen::render {

template <class Real, template <class> class Response, class PlacedLights>
void shine_from_places(Wave<Real>& wave, const PlacedLights& lights) {
  using L = Wide<Real>;
  for (const auto& light : lights) {
    shine<Real, Response>(wave, light, [&](const Entries<L>& hits) {
      return light.kernel.template sample<L>(hits.of(wave.hits.position));
    });
  }
}

}  // namespace alhazen::render
