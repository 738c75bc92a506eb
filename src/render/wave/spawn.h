// render/wave: rays that several hits give rise to, into the queue of the next generation.
#pragma once

#include <algorithm>
#include <array>

#include "core/base/hash.h"
#include "render/wave/meeting.h"

namespace alhazen::render {

// One ray of each hit, where `exists`.
template <class L>
struct Offspring {
  bool reflection;  // back from the surface, else across it
  MaskOf<L> exists;
  Vec3<L> direction;
  Rgb<L> weight;
  IntOf<L> medium;  // a MediumId
  // Goes on along its parent's line: only where a deeper ray might, but is none. A line meets each
  // shape twice at most; what would pass more surfaces than that is thrown to and fro between faces
  // that rounding cannot tell apart, and gets deeper.
  MaskOf<L> straight = false;
};

// Sends on what the hits of one list give rise to, kCount rays of each at most. Those of one kind
// stand together, in the order of the hits: rays that go the same way share lanes in the next
// generation. Of one sample that order is the same whatever else is in the list.
template <class Real, std::size_t kCount>
class Spawner {
 public:
  using L = Wide<Real>;
  using Mask = MaskOf<L>;
  using Int = IntOf<L>;

  Spawner(Wave<Real>& wave, std::size_t hits) : wave_(wave) {
    const std::size_t first = wave.next.size();
    const std::size_t room = hits + L::kWidth;  // lanes are stored whole, the last ones too
    for (std::size_t c = 0; c < kCount; ++c)
      begin_[c] = end_[c] = first + c * room;
    wave.next.grow(first + kCount * room);
  }
  ~Spawner() {
    std::size_t end = end_[0];
    for (std::size_t c = 1; c < kCount; ++c) {
      wave_.next.close_gap(end, begin_[c], end_[c] - begin_[c]);
      end += end_[c] - begin_[c];
    }
    wave_.next.cut(end);
  }
  Spawner(const Spawner&) = delete;
  Spawner& operator=(const Spawner&) = delete;

  void add(const Meeting<L>& met, const std::array<Offspring<L>, kCount>& offspring) {
    const Int depth = met.rays.of(wave_.rays.depth);
    const Mask too_deep = depth >= Int(static_cast<ScalarOf<Int>>(wave_.world.max_depth));
    for (std::size_t c = 0; c < kCount; ++c) {
      const Mask going = going_on(met, offspring[c], too_deep);
      if (any(going)) send(met, offspring[c], depth, going, c);
    }
  }

 private:
  // Those of the rays that are sent on; the others are counted.
  Mask going_on(const Meeting<L>& met, const Offspring<L>& rays, const Mask& too_deep) {
    const Mask some = rays.exists && !is_black(rays.weight);
    const L largest = largest_channel(rays.weight);
    const Mask dim = largest < L(wave_.world.cutoff);
    if (!wave_.slots.margin.empty()) {
      for_each_lane(some && !too_deep, [&](int k) {
        wave_.weigh(slot_of(met, k), relative_gap(largest[k], wave_.world.cutoff));
      });
    }
    const Mask cut = some && (too_deep || dim);
    if (any(cut)) {
      wave_.counters.cut_by_depth += static_cast<std::uint64_t>(count(some && too_deep));
      wave_.counters.cut_by_weight += static_cast<std::uint64_t>(count(some && !too_deep && dim));
      const Colors<L> weight(rays.weight);
      for_each_lane(cut, [&](int k) { wave_.slots.dropped[slot_of(met, k)] += weight[k]; });
    }
    return some && !cut;
  }

  void send(const Meeting<L>& met, const Offspring<L>& rays, const Int& depth, const Mask& going,
            std::size_t c) {
    auto& next = wave_.next;
    const std::size_t first = end_[c];
    store_lanes(going, met.position, next.origin, first);
    store_lanes(going, rays.direction, next.direction, first);
    store_lanes(going, rays.weight, next.weight, first);
    next.source.store(first, going, met.hits.of(wave_.hits.hit.shape),
                      met.hits.of(wave_.hits.hit.face),
                      departure_sides<L>(met.enters == Mask(rays.reflection)), met.incident);
    rays.medium.store_compressed(going, next.medium.data() + first);
    const Mask straight = going && rays.straight;
    const Mask counted = straight && !goes_to_and_fro(met, straight);
    (depth + select(counted, Int(0), Int(1))).store_compressed(going, next.depth.data() + first);
    end_[c] += static_cast<std::size_t>(
        met.rays.of(wave_.rays.slot).store_compressed(going, next.slot.data() + first));
    std::fill_n(next.passed.data() + first, end_[c] - first, 0);
    std::size_t i = first;
    if (any(straight)) {
      for_each_lane(going, [&](int k) {
        next.passed[i++] = straight[k] ? wave_.rays.passed[met.rays[k]] + (counted[k] ? 1 : 0) : 0;
      });
    }
    i = first;
    if (names_paths_) {
      for_each_lane(going, [&](int k) {
        next.path[i++] = mix_64(wave_.rays.path[met.rays[k]], rays.reflection ? 1 : 2);
      });
    }
    if (!wave_.slots.rays.empty()) {
      for_each_lane(going, [&](int k) { ++wave_.slots.rays[slot_of(met, k)]; });
    }
    (rays.reflection ? wave_.counters.reflection_rays : wave_.counters.refraction_rays) +=
        end_[c] - first;
    // Only there can a ray remember more than the surface that it leaves.
    const bool may_remember =
        !wave_.hits.passed.empty() || any(going && met.hits.of(wave_.hits.hit.t) == L(0));
    if (!may_remember) return;
    i = first;
    for_each_lane(going, [&](int k) {
      next.source.set(i++, wave_.source_at(met.hits[k], !rays.reflection));
    });
  }

  Mask goes_to_and_fro(const Meeting<L>& met, const Mask& straight) const {
    const std::size_t most = 2 * wave_.world.material_of.size();
    std::uint32_t bits = 0;
    for_each_lane(straight,
                  [&](int k) { bits |= (wave_.rays.passed[met.rays[k]] < most ? 0U : 1U) << k; });
    return Mask::from_bits(bits);
  }

  SlotId slot_of(const Meeting<L>& met, int lane) const {
    return static_cast<SlotId>(wave_.rays.slot[met.rays[lane]]);
  }

  Wave<Real>& wave_;
  bool names_paths_ = wave_.names_paths();
  std::array<std::size_t, kCount> begin_, end_;  // of each kind's rays, in the next generation
};

}  // namespace alhazen::render
