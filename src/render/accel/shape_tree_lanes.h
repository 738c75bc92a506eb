// render/accel: closest_hit, next_hit and any_hit of shape_tree.h for lanes of rays: a packet walks
// the tree together, and rays that few others go along with walk on alone (docs/acceleration.md).
#pragma once

#include "render/accel/packet_walk.h"

namespace alhazen::render {

// Each active lane has what the function for single rays has, to the last bit. `from` is what
// source_of(lane) says of the shape; source_of is asked for the rest, rarely.
template <class L, class SourceOf>
inline HitLanes<L> closest_hits(const ShapeTree<ScalarOf<L>>& tree, const Ray<L>& ray,
                                const DepartureLanes<L>& from, const SourceOf& source_of, L t_max,
                                IntOf<L> ignored, MaskOf<L> active) {
  FirstHits<L> targets(t_max, active, nullptr);
  find(tree, LaneQuery<L, SourceOf>{tree.table(), ray, from, source_of, ignored}, targets);
  return targets.found();
}

// After `previous`, which has found a hit in every active lane.
template <class L, class SourceOf>
inline HitLanes<L> next_hits(const ShapeTree<ScalarOf<L>>& tree, const Ray<L>& ray,
                             const DepartureLanes<L>& from, const SourceOf& source_of,
                             const HitLanes<L>& previous, L t_max, IntOf<L> ignored,
                             MaskOf<L> active) {
  FirstHits<L> targets(t_max, active, &previous);
  find(tree, LaneQuery<L, SourceOf>{tree.table(), ray, from, source_of, ignored}, targets);
  return targets.found();
}

template <class L, class SourceOf>
inline MaskOf<L> any_hits(const ShapeTree<ScalarOf<L>>& tree, const Ray<L>& ray,
                          const DepartureLanes<L>& from, const SourceOf& source_of, L t_max,
                          IntOf<L> ignored, MaskOf<L> active) {
  AnyHits<L> targets(t_max, active);
  find(tree, LaneQuery<L, SourceOf>{tree.table(), ray, from, source_of, ignored}, targets);
  return targets.found();
}

}  // namespace alhazen::render
