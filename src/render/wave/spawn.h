// render/wave: rays that several hits give rise to, into the queue of the next generation.
#pragma once

#include <array>

#include "render/wave/meeting.h"

namespace alhazen::render {

// One ray of each hit, where `exists`.
template <class L>
struct Offspring {
  bool reflection;  // back from the surface, else across it
  MaskOf<L> exists;
  Vec3<L> direction;
  Rgb<L> weight;
  std::array<MediumId, L::kWidth> medium;
};

// As Wave::spawn: those of the rays that are sent on; the others are counted, each sample's in the
// order of its hits.
template <class Real, class L, std::size_t kCount>
std::array<MaskOf<L>, kCount> going_on(Wave<Real>& wave, const Meeting<L>& met,
                                       const std::array<Offspring<L>, kCount>& offspring) {
  std::uint32_t deepest = 0;
  for_each_lane(met.hits.active(), [&](int k) {
    if (wave.rays.depth[met.rays[k]] >= wave.world.max_depth) deepest |= 1U << k;
  });
  const auto too_deep = MaskOf<L>::from_bits(deepest);
  std::array<MaskOf<L>, kCount> going, cut;
  MaskOf<L> any_cut = false;
  for (std::size_t c = 0; c < kCount; ++c) {
    const MaskOf<L> some = offspring[c].exists && !is_black(offspring[c].weight);
    const MaskOf<L> dim = largest_channel(offspring[c].weight) < L(wave.world.cutoff);
    wave.counters.cut_by_depth += static_cast<std::uint64_t>(count(some && too_deep));
    wave.counters.cut_by_weight += static_cast<std::uint64_t>(count(some && !too_deep && dim));
    if (!wave.slots.margin.empty()) {
      const Numbers<L> largest(largest_channel(offspring[c].weight));
      for_each_lane(some && !too_deep, [&](int k) {
        wave.weigh(wave.rays.slot[met.rays[k]], relative_gap(largest[k], wave.world.cutoff));
      });
    }
    cut[c] = some && (too_deep || dim);
    going[c] = some && !cut[c];
    any_cut = any_cut || cut[c];
  }
  for_each_lane(any_cut, [&](int k) {
    for (std::size_t c = 0; c < kCount; ++c) {
      if (!cut[c][k]) continue;
      const Rgb<L>& weight = offspring[c].weight;
      wave.slots.dropped[wave.rays.slot[met.rays[k]]] +=
          Rgb<Real>(weight.r[k], weight.g[k], weight.b[k]);
    }
  });
  return going;
}

// The rays of each hit stand together, in the order of `offspring`.
template <class Real, class L, std::size_t kCount>
void spawn(Wave<Real>& wave, const Meeting<L>& met,
           const std::array<Offspring<L>, kCount>& offspring) {
  const std::array<MaskOf<L>, kCount> going = going_on(wave, met, offspring);
  std::array<LanePlaces<L>, kCount> places;
  std::size_t end = wave.next.size();
  for_each_lane(met.hits.active(), [&](int k) {
    for (std::size_t c = 0; c < kCount; ++c) {
      if (going[c][k]) places[c].add(k, end++);
    }
  });
  wave.next.grow(end);
  const IntOf<L> above(static_cast<int>(Side::kAbove)), below(static_cast<int>(Side::kBelow));
  // Only there can a ray remember more than the surface that it leaves.
  const bool may_remember =
      !wave.hits.passed.empty() || any(met.hits.active() && met.hits.of(wave.hits.hit.t) == L(0));
  for (std::size_t c = 0; c < kCount; ++c) {
    const Offspring<L>& rays = offspring[c];
    const LanePlaces<L>& to = places[c];
    auto& next = wave.next;
    to.put(met.position, next.origin);
    to.put(rays.direction, next.direction);
    to.put(rays.weight, next.weight);
    to.put(met.hits.of(wave.hits.hit.shape), next.source.shape);
    to.put(met.hits.of(wave.hits.hit.face), next.source.face);
    to.put(select(met.enters == MaskOf<L>(rays.reflection), above, below), next.source.side);
    to.put(met.incident, next.source.arrival);
    (rays.reflection ? wave.counters.reflection_rays : wave.counters.refraction_rays) += to.count();
    to.for_each([&](int k, std::size_t i) {
      const std::size_t parent = met.rays[k];
      const SlotId slot = wave.rays.slot[parent];
      ++wave.slots.rays[slot];
      next.slot[i] = slot;
      next.medium[i] = rays.medium[static_cast<std::size_t>(k)];
      next.path[i] = mix_64(wave.rays.path[parent], rays.reflection ? 1 : 2);
      next.depth[i] = wave.rays.depth[parent] + 1;
      next.passed[i] = 0;
      next.source.memory[i] = -1;
      if (may_remember) next.source.set(i, wave.source_at(met.hits[k], !rays.reflection));
    });
  }
}

}  // namespace alhazen::render
