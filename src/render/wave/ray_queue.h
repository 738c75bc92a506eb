// render/wave: rays in flight, structure of arrays, in the order that every stage keeps.
//
// Order is what makes a picture's bits independent of how work is cut: of one camera sample's rays
// each stage handles them in queue order and appends in that order, so the sum into the sample is
// the same whatever else shares the batch (docs/waves.md).
#pragma once

#include "render/wave/media.h"
#include "render/wave/source_column.h"

namespace alhazen::render {

// The camera sample of a batch that a ray belongs to.
using SlotId = std::uint32_t;

template <class Real>
class RayQueue {
 public:
  Vec3Column<Real> origin, direction;
  SourceColumn<Real> source;
  RgbColumn<Real> weight;        // of the radiance that comes along the ray, in the sample's
  Column<LaneInt<Real>> slot;    // a SlotId
  Column<LaneInt<Real>> medium;  // a MediumId: what the ray starts in
  // Names the branch of the ray tree, and seeds its random numbers, where the wave asks for names.
  Column<std::uint64_t> path;
  Column<LaneInt<Real>> depth;   // reflections and refractions so far
  Column<std::uint32_t> passed;  // surfaces that the same line has come straight through

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Ray<Real> ray(std::size_t i) const { return {origin[i], direction[i]}; }

  void clear() {
    size_ = 0;
    source.clear();
  }

  // Makes the queue `count` rays long; the new ones are for the caller to set.
  void grow(std::size_t count) {
    make_room(count);
    size_ = count;
  }

  // Only the first `count` rays stay.
  void cut(std::size_t count) { size_ = count; }

  // The rays [from, from + count) become those from `to` <= from on, and the last of the queue.
  void close_gap(std::size_t to, std::size_t from, std::size_t count) {
    origin.move(to, from, count);
    direction.move(to, from, count);
    source.move(to, from, count);
    weight.move(to, from, count);
    slot.move(to, from, count);
    medium.move(to, from, count);
    path.move(to, from, count);
    depth.move(to, from, count);
    passed.move(to, from, count);
    size_ = to + count;
  }

  // Becomes the rays order[0], order[1], ... order[count - 1] of `from`.
  void take(const RayQueue& from, const std::uint32_t* order, std::size_t count) {
    clear();
    make_room(count);
    size_ = count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = order[i];
      origin.set(i, from.origin[k]);
      direction.set(i, from.direction[k]);
      source.copy(i, from.source, k);
      weight.set(i, from.weight[k]);
      slot[i] = from.slot[k];
      medium[i] = from.medium[k];
      path[i] = from.path[k];
      depth[i] = from.depth[k];
      passed[i] = from.passed[k];
    }
  }

 private:
  // The columns have grown together, so one of them tells of all.
  void make_room(std::size_t count) {
    if (slot.room() >= count) return;
    origin.make_room(count);
    direction.make_room(count);
    source.make_room(count);
    weight.make_room(count);
    slot.make_room(count);
    medium.make_room(count);
    path.make_room(count);
    depth.make_room(count);
    passed.make_room(count);
  }

  std::size_t size_ = 0;
};

}  // namespace alhazen::render
