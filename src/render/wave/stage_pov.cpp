// render/wave: what POV-Ray's finishes do besides answering to lights: they glow by themselves,
// reflect, and let light through (docs/pov_ray.md).
#include "render/surface/pov_finish.h"
#include "render/wave/onward.h"
#include "render/wave/passage.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real>
void add_pov_glow(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.pov_glowing, [&](const Entries<L>& hits) {
    const Rgb<L> glow = wave.world.materials.template records_of<L>(
        &MaterialRecord<Real>::pov_glow, hits.of(wave.hits.material), hits.active());
    const Entries<L> rays(hits.of(wave.hits.ray), hits.active());
    wave.add(rays, hits.active(), hits.of(wave.hits.color) * glow);
  });
}

// Hits on finishes that reflect or are clear.
template <class L>
struct PovHits {
  IntOf<L> material;
  IntOf<L> behind;  // the lists of media beyond the surfaces
  PovPassage<L> passage;
  DielectricInterface<L> interface;
  L eta;
  Rgb<L> reflected;    // the part that is
  Rgb<L> transmitted;  // the part that is, if there is no total reflection
  // Total reflection takes the place of the other, but only where light would pass: POV-Ray does
  // not look for it where `conserve_energy` has left nothing.
  MaskOf<L> reflects_totally = false;
};

// Against the surfaces' outward normals. An opaque surface that is met from behind, by a ray that
// is not known to be inside of it, is the back of a sheet: POV-Ray takes either side of a sheet for
// the outside.
template <class Real, class L>
MaskOf<L> pov_enters(const Wave<Real>& wave, const Meeting<L>& met, const IntOf<L>& medium,
                     const IntOf<L>& material, MaskOf<L> is_opaque) {
  std::uint32_t backs = 0;
  for_each_lane(is_opaque && !met.enters, [&](int k) {
    const bool inside =
        wave.media.contains(static_cast<MediumId>(medium[k]), static_cast<MaterialId>(material[k]));
    backs |= (inside ? 0U : 1U) << k;
  });
  return met.enters || MaskOf<L>::from_bits(backs);
}

// Index of this side over that of the other, as a `fresnel` reflection goes by it. On leaving one
// solid of several it is not the one that rays are bent by: POV-Ray 3.7 takes the solid entered
// last for the other side, also where that is the one being left.
template <class L>
L pov_fresnel_eta(const PassageLanes<L>& passage, const L& own, MaskOf<L> entering) {
  const L on_leaving = select(passage.behind == IntOf<L>(kVacuum), own, own / passage.ior_here);
  return select(entering, passage.ior_here / own, on_leaving);
}

template <class Real, class L>
PovHits<L> find_pov_hits(Wave<Real>& wave, const Meeting<L>& met) {
  PovHits<L> found;
  const MaskOf<L> active = met.hits.active();
  const IntOf<L> medium = met.rays.of(wave.rays.medium), material = met.hits.of(wave.hits.material);
  const auto& materials = wave.world.materials;
  found.material = material;
  const PovMirror<L> mirror =
      materials.template records_of<L>(&MaterialRecord<Real>::pov_mirror, material, active);
  const L cosine = incident_cosine(met);
  const Rgb<L> color = met.hits.of(wave.hits.color);
  const IntOf<L> way = materials.template ways_of<L>(material, active);
  const MaskOf<L> is_opaque = active && way == IntOf<L>(static_cast<int>(Way::ends));
  const MaskOf<L> by_fresnel = active && mirror.fresnel != L(0);
  if (all(is_opaque || !active) && !any(by_fresnel)) {  // what is behind does not matter
    found.reflected = pov_reflectance(mirror, color, cosine, L(0));
    return found;
  }
  const MaskOf<L> enters = pov_enters(wave, met, medium, material, is_opaque);
  const PassageLanes<L> passage =
      cross_shapes<L>(wave, medium, met.hits.of(wave.hits.hit.shape), material, enters, active);
  found.behind = passage.behind;
  found.eta = passage.ior_here / passage.ior_behind;
  found.interface = dielectric_interface(cosine, found.eta);
  L fresnel = 0;
  if (any(by_fresnel)) {
    const L own = materials.template numbers_of<L>(&MaterialRecord<Real>::ior, material, active);
    fresnel = dielectric_interface(cosine, pov_fresnel_eta(passage, own, enters)).reflectance;
  }
  found.reflected = pov_reflectance(mirror, color, cosine, fresnel);
  found.passage =
      materials.template records_of<L>(&MaterialRecord<Real>::pov_passage, material, active);
  const Rgb<L> passed = pov_passed(found.passage, color);
  found.transmitted =
      select(mirror.conserves_energy != L(0), passed * pov_rest(found.reflected), passed);
  found.reflects_totally = found.interface.total_reflection && !is_black(found.transmitted);
  return found;
}

template <class Real>
void reflect_as_pov(Wave<Real>& wave) {
  using L = Wide<Real>;
  Spawner<Real, 1> spawner(wave, wave.pov_mirror.size());
  for_lanes<L>(wave.pov_mirror, [&](const Entries<L>& hits) {
    const Meeting<L> met(wave, hits);
    const PovHits<L> found = find_pov_hits(wave, met);
    const MaskOf<L> which = hits.active() && !found.reflects_totally;
    spawner.add(met, {reflection(wave, met, which, found.reflected)});
  });
}

// What has passed a solid is faded on leaving it. A ray that is not bent counts as no deeper one.
template <class Real>
void transmit_as_pov(Wave<Real>& wave) {
  using L = Wide<Real>;
  Spawner<Real, 2> spawner(wave, wave.pov_clear.size());
  for_lanes<L>(wave.pov_clear, [&](const Entries<L>& hits) {
    const Meeting<L> met(wave, hits);
    const PovHits<L> found = find_pov_hits(wave, met);
    const MaskOf<L> leaves = hits.active() && found.passage.fades != L(0) && !met.enters;
    Rgb<L> left(L(1));
    if (any(leaves)) {
      const PovFading<L> fading = wave.world.materials.template records_of<L>(
          &MaterialRecord<Real>::pov_fading, found.material, leaves);
      left = select(leaves, pov_fade(fading, hits.of(wave.hits.hit.t)), left);
    }
    const MaskOf<L> straight = found.eta == L(1);
    const Vec3<L> onward = crossing_direction(met, found.eta, found.interface);
    spawner.add(met,
                {reflection(wave, met, hits.active() && found.reflects_totally, left),
                 Offspring<L>{false, hits.active() && !found.interface.total_reflection,
                              select(straight, met.incident, onward),
                              met.weight * (left * found.transmitted), found.behind, straight}});
  });
}

template struct StagesOf<StageHome::pov>;

}  // namespace alhazen::render
