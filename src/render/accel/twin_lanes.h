// render/accel: twin_hits.h for lanes of rays.
#pragma once

#include "render/accel/lane_targets.h"
#include "render/accel/twin_hits.h"

namespace alhazen::render {

// What lanes of rays ask of shapes that stand in for others, and what is known without asking.
template <class L>
class LayerQuery {
 public:
  using Real = ScalarOf<L>;

  template <class Shapes, class SourceOf>
  LayerQuery(const Shapes& table, const Ray<L>& ray, const SourceOf& source_of,
             const IntOf<L>& ignored, MaskOf<L> active)
      : twins_(table.twins()) {
    using Word = ScalarOf<IntOf<L>>;
    at_start_.found = false;
    ignored_ = ignored;
    for_each_lane(active, [&](int i) {
      const Source source = source_of(i);
      const auto without = static_cast<ShapeId>(ignored[i]);
      if (const auto hit = hit_on_next_layer(table, one_ray(ray, i), source, without))
        at_start_.set(i, *hit);
      const Source& from = sources_[static_cast<std::size_t>(i)] = standing_in(twins_, source);
      from_.shape.set(i, static_cast<Word>(from.shape));
      from_.face.set(i, static_cast<Word>(from.face));
      from_.side.set(i, static_cast<Word>(from.side));
      ignored_.set(i, static_cast<Word>(twins_.stand_in(without)));
    });
    to_search_ = active && !at_start_.found;
  }

  const DepartureLanes<L>& from() const { return from_; }
  const IntOf<L>& ignored() const { return ignored_; }
  MaskOf<L> to_search() const { return to_search_; }
  MaskOf<L> at_start() const { return at_start_.found; }
  const Source& source(int lane) const { return sources_[static_cast<std::size_t>(lane)]; }

  // With what the search has found.
  HitLanes<L> all(HitLanes<L> found) const {
    using Word = ScalarOf<IntOf<L>>;
    for_each_lane(found.found, [&](int i) {
      const auto stand_in = static_cast<ShapeId>(found.shape[i]);
      found.shape.set(i, static_cast<Word>(twins_.first(stand_in, found.enters[i])));
    });
    for_each_lane(at_start_.found, [&](int i) { found.set(i, at_start_[i]); });
    return found;
  }

 private:
  const Twins& twins_;
  std::array<Source, L::kWidth> sources_;
  DepartureLanes<L> from_;
  IntOf<L> ignored_;
  MaskOf<L> to_search_;
  HitLanes<L> at_start_;
};

}  // namespace alhazen::render
