// render/accel: closest_hit, next_hit and any_hit of shape_tree.h and world_tree.h for lanes of
// rays: a packet walks the tree together, and rays that few others go along with walk on alone
// (docs/acceleration.md).
#pragma once

#include "render/accel/instance_lanes.h"
#include "render/accel/twin_lanes.h"

namespace alhazen::render {

// Tree is a ShapeTree or the WorldTree of ScalarOf<L>. Each active lane has what the function for
// single rays has, to the last bit. `from` is what source_of(lane) says of the shape; source_of is
// asked for the rest, rarely.
template <class L, class Tree, class SourceOf>
inline HitLanes<L> closest_hits(const Tree& tree, const Ray<L>& ray, const DepartureLanes<L>& from,
                                const SourceOf& source_of, L t_max, IntOf<L> ignored,
                                MaskOf<L> active) {
  const auto& shapes = shapes_of(tree);
  const auto search = [&](const DepartureLanes<L>& leaving, const auto& sources,
                          const IntOf<L>& without, MaskOf<L> lanes) {
    FirstHits<L> targets(t_max, lanes, nullptr);
    find<L>(tree, query_of(shapes, ray, leaving, sources, without), targets);
    return targets.found();
  };
  if (shapes.twins().none()) return search(from, source_of, ignored, active);
  const LayerQuery<L> query(shapes, ray, source_of, ignored, active);
  const auto sources = [&query](int lane) { return query.source(lane); };
  return query.all(search(query.from(), sources, query.ignored(), query.to_search()));
}

// After `previous`, which has found a hit in every active lane.
template <class L, class Tree, class SourceOf>
inline HitLanes<L> next_hits(const Tree& tree, const Ray<L>& ray, const DepartureLanes<L>& from,
                             const SourceOf& source_of, const HitLanes<L>& previous, L t_max,
                             IntOf<L> ignored, MaskOf<L> active) {
  const auto& shapes = shapes_of(tree);
  FirstHits<L> targets(t_max, active, &previous);
  if (shapes.twins().none()) {
    find<L>(tree, query_of(shapes, ray, from, source_of, ignored), targets);
    return targets.found();
  }
  HitLanes<L> hits = targets.found();
  for_each_lane(active, [&](int i) {
    const auto hit = next_hit(tree, one_ray(ray, i), source_of(i), previous[i], t_max[i],
                              static_cast<ShapeId>(ignored[i]));
    if (hit) hits.set(i, *hit);
  });
  return hits;
}

template <class L, class Tree, class SourceOf>
inline MaskOf<L> any_hits(const Tree& tree, const Ray<L>& ray, const DepartureLanes<L>& from,
                          const SourceOf& source_of, L t_max, IntOf<L> ignored, MaskOf<L> active) {
  const auto& shapes = shapes_of(tree);
  const auto search = [&](const DepartureLanes<L>& leaving, const auto& sources,
                          const IntOf<L>& without, MaskOf<L> lanes) {
    AnyHits<L> targets(t_max, lanes);
    find<L>(tree, query_of(shapes, ray, leaving, sources, without), targets);
    return targets.found();
  };
  if (shapes.twins().none()) return search(from, source_of, ignored, active);
  const LayerQuery<L> query(shapes, ray, source_of, ignored, active);
  const auto sources = [&query](int lane) { return query.source(lane); };
  return query.at_start() || search(query.from(), sources, query.ignored(), query.to_search());
}

}  // namespace alhazen::render
