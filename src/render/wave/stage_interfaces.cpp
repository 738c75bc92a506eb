// render/wave: the stage that finds what rays meet, past surfaces that are no interface.
#include "render/wave/first_hits.h"
#include "render/wave/passage.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// What a ray meets past what is no interface, and the media that it has come to there.
template <class Real>
struct InterfaceHit {
  std::optional<Hit<Real>> hit;
  MediumId medium;
  std::optional<std::array<Touched, 4>> passed;  // faces at the very point of the hit
};

// Goes on from `hit`, past what is no interface. Each crossing of the line is visited once, in
// order, so this ends however many solids share a face.
template <class Real>
InterfaceHit<Real> interface_beyond(Wave<Real>& wave, std::size_t i, const Hit<Real>& first) {
  const World<Real>& world = wave.world;
  InterfaceHit<Real> met{first, static_cast<MediumId>(wave.rays.medium[i]), std::nullopt};
  Source passed;  // remembers the faces passed at one point
  Real passed_at = -1;
  while (met.hit) {
    const Hit<Real> hit = *met.hit;
    const MaterialId material = world.material_of[hit.shape];
    const MaterialRoute& route = world.materials.route(material);
    const bool is_glass = route.kind == SurfaceKind::glass;
    if (!is_glass && !(route.pov_clear && !world.thin[hit.shape])) break;
    met.medium = before_surface(wave.media, met.medium, material, hit.enters);
    if (!is_glass) break;  // its colour counts, whatever the media
    const Passage<Real> passage =
        cross_surface(world, wave.media, met.medium, material, hit.enters);
    if (passage.is_interface) break;
    met.medium = passage.behind;
    if (hit.t != passed_at) passed = {};
    passed_at = hit.t;
    passed.remember({hit.shape, hit.face, hit.enters ? Side::kBelow : Side::kAbove});
    met.hit = next_hit(world.tree, wave.rays.ray(i), wave.rays.source[i], hit, infinity<Real>());
  }
  if (met.hit && met.hit->t == passed_at) met.passed = passed.earlier;
  return met;
}

// A surface with the same medium on both sides is no interface: the ray goes on along its line, and
// only its list of media changes.
template <class Real>
void find_interfaces(Wave<Real>& wave) {
  using L = Packet<Real>;
  const World<Real>& world = wave.world;
  for_lanes<L>(wave.rays.size(), [&](const Entries<L>& at) {
    HitLanes<L> hits = first_hits(wave, at);
    const MaskOf<L> met = at.active() && hits.found;
    const IntOf<L> material = world.template materials_at<L>(hits.shape, met);
    const IntOf<L> way = world.materials.template ways_of<L>(material, met);
    const MaskOf<L> is_glass = way == IntOf<L>(static_cast<int>(Way::through_glass));
    const MaskOf<L> plain =
        is_plain_passage<L>(at.of(wave.rays.medium), material, hits.enters, met && is_glass);
    std::uint32_t found = met.bits();
    const auto place = [&](int k) {  // among the hits, of the one in lane k
      const std::uint32_t before = found & ((std::uint32_t{1} << k) - 1);
      return wave.hits.size() + static_cast<std::size_t>(__builtin_popcount(before));
    };
    for_each_lane(met && !plain && way != IntOf<L>(static_cast<int>(Way::ends)), [&](int k) {
      const InterfaceHit<Real> beyond = interface_beyond(wave, at[k], hits[k]);
      wave.rays.medium[at[k]] = beyond.medium;
      if (!beyond.hit) {
        found &= ~(std::uint32_t{1} << k);
        return;
      }
      hits.set(k, *beyond.hit);
      // Lanes go from the lowest up: those below have been decided.
      if (beyond.passed) {
        wave.hits.passed.push_back({static_cast<std::uint32_t>(place(k)), *beyond.passed});
      }
    });
    const MaskOf<L> kept = MaskOf<L>::from_bits(found);
    wave.hits.append(at.index(), hits, kept);
    wave.escaped.append(at.index(), at.active() && !kept);
  });
  wave.sort_hits();
}

template struct StagesOf<StageHome::interfaces>;

}  // namespace alhazen::render
