// render/wave: what rays meet first.
#pragma once

#include "render/accel/shape_tree_lanes.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// What several rays of the generation meet first.
template <class L>
HitLanes<L> first_hits(const Wave<ScalarOf<L>>& wave, const Entries<L>& at) {
  const auto& rays = wave.rays;
  return closest_hits(
      wave.world.tree, Ray<L>{at.of(rays.origin), at.of(rays.direction)},
      rays.source.departures(at), [&](int lane) { return rays.source[at[lane]]; }, L(infinity<L>()),
      IntOf<L>(-1), at.active());
}

}  // namespace alhazen::render
