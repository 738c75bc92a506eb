// render/wave: where rays meet surfaces.
#pragma once

#include "render/wave/surface_color.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// Position and normals, and where the colour is a texture the coordinates that it asks for. The
// shading normal is turned to the side that the ray came from.
template <class Real, bool with_coordinates>
void find_surfaces(Wave<Real>& wave) {
  using L = Wide<Real>;
  auto& hits = wave.hits;
  if constexpr (with_coordinates) hits.make_room_for_coordinates();
  for_lanes<L>(hits.size(), [&](const Entries<L>& at) {
    const Entries<L> rays(at.of(hits.ray), at.active());
    const Ray<L> ray{rays.of(wave.rays.origin), rays.of(wave.rays.direction)};
    const IntOf<L> shape = at.of(hits.hit.shape);
    const MaskOf<L> enters = at.of(hits.hit.enters) != IntOf<L>(0);
    const Crossing<L> crossing{at.of(hits.hit.t), at.of(hits.hit.face), enters};
    SurfacePoint<L> point;
    if constexpr (with_coordinates) {
      const MaskOf<L> asks = are_textured<L>(wave.world, at.of(hits.material), at.active());
      const MaskOf<L> others = at.active() && !asks;
      if (any(asks)) point = wave.world.shapes.template surface<L>(shape, ray, crossing, asks);
      if (any(others)) {
        point = select(asks, point,
                       wave.world.shapes.template plain_surface<L>(shape, ray, crossing, others));
      }
      at.store(point.object_position, hits.object_position);
      at.store(point.u, hits.u);
      at.store(point.v, hits.v);
    } else {
      point = wave.world.shapes.template plain_surface<L>(shape, ray, crossing, at.active());
    }
    at.store(point.position, hits.position);
    at.store(point.normal, hits.geometric_normal);
    at.store(select(enters, point.shading_normal, -point.shading_normal), hits.shading_normal);
  });
}

}  // namespace alhazen::render
