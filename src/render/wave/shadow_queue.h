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
  Column<SlotId> slot;
  Column<MediumId> medium;

  std::size_t size() const { return size_; }
  void clear() {
    size_ = 0;
    source.clear();
  }
  void push(const Ray<Real>& ray, const Source& from, Real dist, ShapeId lamp, Rgb<Real> l,
            SlotId s, MediumId m) {
    if (size_ == slot.room()) make_room(size_ + 1);
    const std::size_t i = size_++;
    origin.set(i, ray.origin);
    direction.set(i, ray.direction);
    source.set(i, from);
    distance[i] = dist;
    light_shape[i] = static_cast<std::int32_t>(lamp);
    radiance.set(i, l);
    slot[i] = s;
    medium[i] = m;
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
