// render/wave: light on its way to a surface: what it will add if nothing stands between.
#pragma once

#include "render/wave/entries.h"

namespace alhazen::render {

// A path starts at a hit of the generation, and all else about its start stands there. There are
// many times as many paths as hits where there are many lights, so they are kept small.
template <class Real>
class ShadowQueue {
 public:
  Column<LaneInt<Real>> hit;  // index into the generation's HitQueue
  Vec3Column<Real> direction;
  Column<Real> distance;  // to the light; infinite for a directional one
  // The light's own visible surface, which does not shadow it; -1: none.
  Column<LaneInt<Real>> light_shape;
  RgbColumn<Real> radiance;

  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }
  // The paths of several lanes, in their order.
  template <class L>
  void append(MaskOf<L> which, const IntOf<L>& hits, const Vec3<L>& towards, const L& dist,
              const IntOf<L>& lamps, const Rgb<L>& light) {
    make_room(size_ + L::kWidth);
    store_lanes(which, towards, direction, size_);
    dist.store_compressed(which, distance.data() + size_);
    lamps.store_compressed(which, light_shape.data() + size_);
    store_lanes(which, light, radiance, size_);
    size_ += static_cast<std::size_t>(hits.store_compressed(which, hit.data() + size_));
  }

 private:
  // The columns have grown together, so one of them tells of all.
  void make_room(std::size_t count) {
    if (hit.room() >= count) return;
    hit.make_room(count);
    direction.make_room(count);
    distance.make_room(count);
    light_shape.make_room(count);
    radiance.make_room(count);
  }

  std::size_t size_ = 0;
};

}  // namespace alhazen::render
