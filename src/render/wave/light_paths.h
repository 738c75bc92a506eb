// render/wave: paths of light from lamps to hits.
#pragma once

#include "render/accel/shape_tree_lanes.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// Several light paths of the generation.
template <class L>
struct LightPaths {
  using Real = ScalarOf<L>;

  LightPaths(const Wave<Real>& wave_, const ShadowQueue<Real>& paths, const Entries<L>& at)
      : wave(wave_),
        hits(at.of(paths.hit), at.active()),
        rays(hits.of(wave.hits.ray), at.active()),
        active(at.active()),
        ray{hits.of(wave.hits.position), at.of(paths.direction)},
        distance(at.of(paths.distance)),
        lamp(at.of(paths.light_shape)),
        radiance(at.of(paths.radiance)) {
    const MaskOf<L> above = hits.of(wave.hits.hit.enters) != IntOf<L>(0);
    from = {hits.of(wave.hits.hit.shape), hits.of(wave.hits.hit.face), departure_sides<L>(above)};
  }
  Source source_of(int lane) const { return wave.source_at(hits[lane], false); }

  const Wave<Real>& wave;
  Entries<L> hits, rays;  // where they start, and what came there
  MaskOf<L> active;
  Ray<L> ray;
  L distance;
  IntOf<L> lamp;
  Rgb<L> radiance;
  DepartureLanes<L> from;
};

template <class Real>
void count_shadow_rays(Wave<Real>& wave) {
  const ShadowQueue<Real>& paths = wave.light_paths;
  wave.counters.shadow_rays += paths.size();
  if (wave.slots.rays.empty()) return;
  for (std::size_t i = 0; i < paths.size(); ++i)
    ++wave.slots.rays[wave.slot_of_hit(static_cast<std::size_t>(paths.hit[i]))];
}

// Adds radiance to the samples of rays that have met where it arrives, in their order.
template <class L>
void add_arrived(Wave<ScalarOf<L>>& wave, const Entries<L>& rays, MaskOf<L> which,
                 const Rgb<L>& radiance) {
  const Colors<L> arrived(radiance);
  const Numbers<IntOf<L>> slot(rays.of(wave.rays.slot));
  for_each_lane(which, [&](int k) { wave.slots.radiance[slot[k]] += arrived[k]; });
}

}  // namespace alhazen::render
