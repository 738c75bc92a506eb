// render/accel: hit.h for lanes of rays. No shape is -1, as no face is.
#pragma once

#include "render/accel/hit.h"
#include "render/simd/lanes.h"

namespace alhazen::render {

// Where each ray departs from; what a Source knows besides is asked for where it is needed.
template <class L>
struct DepartureLanes {
  IntOf<L> shape{-1}, face{kNoFace}, side{static_cast<int>(Side::kByDirection)};
};

// Whose rays leave on the outside of the surface where `above`.
template <class L>
inline IntOf<L> departure_sides(MaskOf<L> above) {
  return select(above, IntOf<L>(static_cast<int>(Side::kAbove)),
                IntOf<L>(static_cast<int>(Side::kBelow)));
}

// Lanes in which nothing was found have no other meaning.
template <class L>
struct HitLanes {
  L t;
  IntOf<L> shape, face;
  MaskOf<L> enters, found;

  Hit<ScalarOf<L>> operator[](int lane) const {
    return {t[lane], static_cast<ShapeId>(shape[lane]), static_cast<int>(face[lane]), enters[lane]};
  }
  void set(int lane, const Hit<ScalarOf<L>>& hit) {
    using Mask = MaskOf<L>;
    using Word = ScalarOf<IntOf<L>>;
    const Mask here = Mask::from_bits(std::uint32_t{1} << lane);
    t.set(lane, hit.t);
    shape.set(lane, static_cast<Word>(hit.shape));
    face.set(lane, static_cast<Word>(hit.face));
    enters = (enters && !here) || (here && Mask(hit.enters));
    found = found || here;
  }
};

// The order of hits of hit.h for two that have the same t.
template <class L>
inline MaskOf<L> precedes_at_one_place(const HitLanes<L>& a, const HitLanes<L>& b) {
  const MaskOf<L> by_number = a.shape < b.shape || (a.shape == b.shape && a.face < b.face);
  return (a.enters && !b.enters) || (a.enters == b.enters && by_number);
}

template <class L>
inline Ray<ScalarOf<L>> one_ray(const Ray<L>& ray, int lane) {
  return {{ray.origin.x[lane], ray.origin.y[lane], ray.origin.z[lane]},
          {ray.direction.x[lane], ray.direction.y[lane], ray.direction.z[lane]}};
}

}  // namespace alhazen::render
