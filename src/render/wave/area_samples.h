// render/wave: the samples of area lights, W at a time.
#pragma once

#include "core/math/random.h"
#include "render/simd/records.h"
#include "render/wave/entries.h"
#include "render/wave/stage_camera.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// The samples of one light at one branch of a pixel's ray trees are one sequence, through all
// camera samples of the pixel: together they are spread over the light as evenly as the samples of
// one. Those at a hit are the numbers from `first` on.
struct AreaSequence {
  std::uint64_t seed;
  std::uint32_t first;
};
template <class Real, class Placed>
AreaSequence area_sequence(const Wave<Real>& wave, const Placed& light, std::size_t h) {
  const std::size_t i = wave.hits.ray_of(h);
  return {mix_64(wave.rays.path[i], kFirstLightDimension + light.id),
          wave.slots.sample[wave.rays.slot[i]] * static_cast<std::uint32_t>(light.kernel.samples)};
}

// Deals the samples at W hits to lanes: sample after sample at one hit, then those at the next.
// Lanes are full, and light paths from one point to one light stand side by side.
template <class L>
class AreaDealer {
 public:
  template <class Placed>
  AreaDealer(const Wave<ScalarOf<L>>& wave, const Placed& light, const Entries<L>& hits)
      : hits_(count(hits.active())), samples_(light.kernel.samples) {
    for (int k = 0; k < hits_; ++k)
      sequences_[k] = area_sequence(wave, light, hits[k]);
  }

  // One sample a hit: every lane keeps its own.
  bool keeps_lanes() const { return samples_ == 1; }

  // Afterwards the active() lanes have sample (u(), v()) at the hit that stood in lane from().
  // False if there are none left.
  bool deal() {
    if (hit_ == hits_) return false;
    std::array<std::uint64_t, kWidth> seeds{};
    std::array<std::uint32_t, kWidth> numbers{};
    std::array<ScalarOf<IntOf<L>>, kWidth> from{};
    int lanes = 0;
    for (; lanes < L::kWidth && hit_ < hits_; ++lanes) {
      from[lanes] = hit_;
      seeds[lanes] = sequences_[hit_].seed;
      numbers[lanes] = sequences_[hit_].first + static_cast<std::uint32_t>(sample_);
      if (++sample_ < samples_) continue;
      sample_ = 0;
      ++hit_;
    }
    active_ = MaskOf<L>::first(lanes);
    from_ = IntOf<L>::load(from.data());
    const auto bits = sample_2d(Lanes<std::uint64_t, L::kWidth>::load(seeds.data()),
                                Lanes<std::uint32_t, L::kWidth>::load(numbers.data()));
    u_ = unit_real<L>(bits.x);
    v_ = unit_real<L>(bits.y);
    return true;
  }

  const MaskOf<L>& active() const { return active_; }
  const IntOf<L>& from() const { return from_; }
  const L& u() const { return u_; }
  const L& v() const { return v_; }

 private:
  static constexpr auto kWidth = static_cast<std::size_t>(L::kWidth);

  int hits_, samples_, hit_ = 0, sample_ = 0;
  std::array<AreaSequence, kWidth> sequences_{};
  MaskOf<L> active_ = false;
  IntOf<L> from_ = 0;
  L u_, v_;
};

// Calls `visit(hits, samples)` with the samples of an area light at some hits. What a hit sees of
// the light is found for W hits at once and only then dealt out.
template <template <class> class View, class L, class Placed, class Visitor>
void visit_area(const Wave<ScalarOf<L>>& wave, const Placed& light, const Entries<L>& hits,
                const Visitor& visit) {
  const View<L> view(light.kernel, hits.of(wave.hits.position));
  AreaDealer<L> dealer(wave, light, hits);
  if (dealer.keeps_lanes()) {
    dealer.deal();
    visit(hits, view.sample(dealer.u(), dealer.v()));
    return;
  }
  const DealtRecords sights(view.sight());
  const DealtLanes indices(hits.index());
  while (dealer.deal()) {
    const View<L> dealt = View<L>::of(light.kernel, sights.to(dealer.from()));
    visit(Entries<L>(indices.to(dealer.from()), dealer.active()),
          dealt.sample(dealer.u(), dealer.v()));
  }
}

}  // namespace alhazen::render
