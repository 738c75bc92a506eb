// render/wave: where the rays of a queue start (accel/hit.h), in columns.
#pragma once

#include "render/accel/hit_lanes.h"
#include "render/wave/entries.h"

namespace alhazen::render {

// A ray that starts where several faces pass through one point remembers those it has met there.
// Nearly none do: such memories are kept in a list, and a ray has a place in it.
template <class Real>
class SourceColumn {
 public:
  Column<LaneInt<Real>> shape, face, side;  // shape -1: from nowhere in particular
  Vec3Column<Real> arrival;
  Column<std::int32_t> memory;  // -1: none

  Source operator[](std::size_t i) const {
    Source source{static_cast<ShapeId>(shape[i]), static_cast<int>(face[i]),
                  static_cast<Side>(side[i]), Vec3d(arrival[i])};
    if (memory[i] >= 0) source.earlier = memories_[static_cast<std::size_t>(memory[i])];
    return source;
  }
  // Of several entries, without what they remember.
  template <class L>
  DepartureLanes<L> departures(const Entries<L>& at) const {
    return {at.of(shape), at.of(face), at.of(side)};
  }
  void set(std::size_t i, const Source& source) {
    shape[i] = static_cast<std::int32_t>(source.shape);
    face[i] = source.face;
    side[i] = static_cast<LaneInt<Real>>(source.side);
    arrival.set(i, Vec3<Real>(source.arrival));  // was one: no rounding
    memory[i] = -1;
    if (source.earlier[0].shape != kNoId) remember(i, source.earlier);
  }
  // The lanes of the mask become the entries from `i` on; they remember
  // nothing.
  template <class L>
  void store(std::size_t i, MaskOf<L> which, const IntOf<L>& shapes, const IntOf<L>& faces,
             const IntOf<L>& sides, const Vec3<L>& came) {
    shapes.store_compressed(which, shape.data() + i);
    faces.store_compressed(which, face.data() + i);
    sides.store_compressed(which, side.data() + i);
    store_lanes(which, came, arrival, i);
    std::fill_n(memory.data() + i, count(which), -1);
  }
  // Entry i becomes a copy of entry k of `from`.
  void copy(std::size_t i, const SourceColumn& from, std::size_t k) {
    shape[i] = from.shape[k];
    face[i] = from.face[k];
    side[i] = from.side[k];
    arrival.set(i, from.arrival[k]);
    memory[i] = -1;
    if (from.memory[k] >= 0) {
      remember(i, from.memories_[static_cast<std::size_t>(from.memory[k])]);
    }
  }
  // The entries [from, from + count) become those from `to` <= from on.
  void move(std::size_t to, std::size_t from, std::size_t count) {
    shape.move(to, from, count);
    face.move(to, from, count);
    side.move(to, from, count);
    arrival.move(to, from, count);
    memory.move(to, from, count);
  }
  void make_room(std::size_t count) {
    shape.make_room(count);
    face.make_room(count);
    side.make_room(count);
    arrival.make_room(count);
    memory.make_room(count);
  }
  void clear() { memories_.clear(); }

 private:
  void remember(std::size_t i, const std::array<Touched, 4>& earlier) {
    memory[i] = static_cast<std::int32_t>(memories_.size());
    memories_.push_back(earlier);
  }

  std::vector<std::array<Touched, 4>> memories_;
};

}  // namespace alhazen::render
