// render/wave: light on its way to a surface: what it will add if nothing stands between.
#pragma once

#include "render/wave/ray_queue.h"

namespace alhazen::render {

template <class Real>
class ShadowQueue {
 public:
  Vec3Column<Real> origin, direction;
  SourceColumn<Real> source;
  Column<Real> distance;  // to the light; infinite for a directional one
  // The light's own visible surface, which does not shadow it; -1: none.
  Column<LaneInt<Real>> light_shape;
  RgbColumn<Real> radiance;
  Column<LaneInt<Real>> slot;    // a SlotId
  Column<LaneInt<Real>> medium;  // a MediumId

  std::size_t size() const { return size_; }
  void clear() {
    size_ = 0;
    source.clear();
  }
  // The paths of several lanes, in their order. Their sources, lamps, samples
  // and media are for the caller to set.
  template <class L>
  void append(MaskOf<L> which, const Ray<L>& ray, const L& dist, const Rgb<L>& l) {
    make_room(size_ + L::kWidth);
    store_lanes(which, ray.origin, origin, size_);
    store_lanes(which, ray.direction, direction, size_);
    dist.store_compressed(which, distance.data() + size_);
    store_lanes(which, l, radiance, size_);
    size_ += static_cast<std::size_t>(count(which));
  }

 private:
  void make_room(std::size_t count) {
    origin.make_room(count);
    direction.make_room(count);
    source.make_room(count);
    distance.make_room(count);
    light_shape.make_room(count);
    radiance.make_room(count);
    slot.make_room(count);
    medium.make_room(count);
  }

  std::size_t size_ = 0;
};

}  // namespace alhazen::render
