// render/wave: the samples of area lights, W at a time.
#pragma once

#include "core/math/random.h"
#include "render/simd/records.h"
#include "render/wave/camera_samples.h"
#include "render/wave/entries.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// The samples of one light at one branch of a pixel's ray trees are one sequence, through all
// camera samples of the pixel: together they are spread over the light as evenly as the samples of
// one. Those at a hit are the numbers from `first` on. `Word` is std::uint64_t or lanes of it.
template <class Word>
struct AreaSequence {
  SequenceKeys<Word> keys;
  Word first;  // its low 32 bits count
};
template <class Placed, class Word>
AreaSequence<Word> area_sequence(const Placed& light, Word path, Word sample) {
  const auto samples = static_cast<std::uint64_t>(light.kernel.samples);
  return {sequence_keys(mix_64(path, Word(kFirstLightDimension + light.id))),
          sample * Word(samples)};
}
template <class Real, class Placed>
AreaSequence<std::uint64_t> area_sequence_at(const Wave<Real>& wave, const Placed& light,
                                             std::size_t h) {
  const std::size_t i = wave.hits.ray_of(h);
  return area_sequence(light, wave.rays.path[i],
                       std::uint64_t{wave.slots.sample[wave.rays.slot[i]]});
}

// Deals the samples at W hits to lanes: sample after sample at one hit, then those at the next.
// Lanes are full, and light paths from one point to one light stand side by side.
template <class L>
class AreaDealer {
 public:
  using Int = IntOf<L>;
  using Words = Lanes<std::uint64_t, L::kWidth>;

  template <class Placed>
  AreaDealer(const Wave<ScalarOf<L>>& wave, const Placed& light, const Entries<L>& hits)
      : hits_(count(hits.active())),
        samples_(static_cast<ScalarOf<Int>>(light.kernel.samples)),
        sequences_(sequences_at(wave, light, hits)),
        next_from_(per_lane<Int>(true, 0, [&](int k) { return k / samples_; })),
        next_sample_(Int::iota() - next_from_ * Int(samples_)) {}

  // One sample a hit: every lane keeps its own.
  bool keeps_lanes() const { return samples_ == 1; }

  // Afterwards the active() lanes have sample (u(), v()) at the hit that stood in lane from().
  // False if there are none left.
  bool deal() {
    active_ = next_from_ < Int(hits_);
    if (!any(active_)) return false;
    from_ = select(active_, next_from_, Int(0));
    const AreaSequence<Words> own = sequences_.to(from_);
    const auto bits = sample_2d_of(own.keys, Numbers32(own.first) + Numbers32(next_sample_));
    u_ = unit_real<L>(bits.x);
    v_ = unit_real<L>(bits.y);
    next_from_ = next_from_ + Int(L::kWidth / samples_);
    next_sample_ = next_sample_ + Int(L::kWidth % samples_);
    const MaskOf<L> over = next_sample_ >= Int(samples_);
    next_from_ = select(over, next_from_ + Int(1), next_from_);
    next_sample_ = select(over, next_sample_ - Int(samples_), next_sample_);
    return true;
  }

  const MaskOf<L>& active() const { return active_; }
  const Int& from() const { return from_; }
  const L& u() const { return u_; }
  const L& v() const { return v_; }

 private:
  using Numbers32 = Lanes<std::uint32_t, L::kWidth>;

  template <class Placed>
  static AreaSequence<Words> sequences_at(const Wave<ScalarOf<L>>& wave, const Placed& light,
                                          const Entries<L>& hits) {
    const Entries<L> rays(hits.of(wave.hits.ray), hits.active());
    const Entries<L> slots(rays.of(wave.rays.slot), hits.active());
    return area_sequence(light, rays.of(wave.rays.path), Words(slots.of(wave.slots.sample)));
  }

  ScalarOf<Int> hits_, samples_;
  DealtRecords<Words, AreaSequence> sequences_;
  // Of each lane the hit that it gets next, by its place, and the sample there.
  Int next_from_, next_sample_;
  MaskOf<L> active_ = false;
  Int from_ = 0;
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
