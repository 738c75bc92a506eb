// render/wave: what POV-Ray's finishes do besides answering to lights: they glow by themselves,
// reflect, and let light through (docs/pov_ray.md).
#pragma once

#include "render/surface/pov_finish.h"
#include "render/wave/stage_glass.h"

namespace alhazen::render {

template <class Real>
void add_pov_glow(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.pov_glowing, [&](const Entries<L>& hits) {
    const PovSurface<L> surface = wave.world.materials.template records_of<L>(
        &MaterialRecord<Real>::pov, hits.of(wave.hits.material), hits.active());
    const Entries<L> rays(hits.of(wave.hits.ray), hits.active());
    wave.add(rays, hits.active(), hits.of(wave.hits.color) * surface.glow);
  });
}

// Hits on finishes that reflect or are clear.
template <class L>
struct PovHits {
  std::array<Passage<ScalarOf<L>>, L::kWidth> passage;
  PovSurface<L> surface;
  DielectricInterface<L> interface;
  L eta;
  Rgb<L> reflected;    // the part that is
  Rgb<L> transmitted;  // the part that is, if there is no total reflection
  // Total reflection takes the place of the other, but only where light would pass: POV-Ray does
  // not look for it where `conserve_energy` has left nothing.
  MaskOf<L> reflects_totally;
};

// Index of this side over that of the other, as a `fresnel` reflection goes by it. On leaving one
// solid of several it is not the one that rays are bent by: POV-Ray 3.7 takes the solid entered
// last for the other side, also where that is the one being left.
template <class Real>
Real pov_fresnel_eta(const Passage<Real>& passage, Real own, bool entering) {
  if (entering) return passage.ior_here / own;
  return passage.behind == kVacuum ? own : own / passage.ior_here;
}

// What a ray crosses at a hit. An opaque surface that is met from behind, by a ray that is not
// known to be inside of it, is the back of a sheet: POV-Ray takes either side of a sheet for the
// outside.
template <class Real>
Passage<Real> pov_passage(Wave<Real>& wave, std::size_t h, bool& enters) {
  const ShapeId shape = wave.hits.hit[h].shape;
  const MaterialId id = wave.hits.material_of(h);
  MediumId here = wave.rays.medium[wave.hits.ray_of(h)];
  if (!wave.world.materials.route(id).pov_clear && !wave.media.contains(here, id)) enters = true;
  if (!wave.world.thin[shape]) here = before_surface(wave.media, here, id, enters);
  return cross_shape(wave.world, wave.media, here, shape, enters);
}

template <class Real, class L>
PovHits<L> find_pov_hits(Wave<Real>& wave, const Meeting<L>& met) {
  PovHits<L> found;
  found.surface = wave.world.materials.template records_of<L>(
      &MaterialRecord<Real>::pov, met.hits.of(wave.hits.material), met.hits.active());
  Real fresnel_eta[L::kWidth] = {};
  found.eta = per_lane<L>(met.hits.active(), Real(1), [&](int k) {
    const std::size_t h = met.hits[k];
    bool enters = met.enters[k];
    found.passage[k] = pov_passage(wave, h, enters);
    const Real own = wave.world.materials[wave.hits.material_of(h)].ior;
    fresnel_eta[k] = pov_fresnel_eta(found.passage[k], own, enters);
    return found.passage[k].ior_here / found.passage[k].ior_behind;
  });
  const L cosine = incident_cosine(met);
  const Rgb<L> color = met.hits.of(wave.hits.color);
  found.interface = dielectric_interface(cosine, found.eta);
  L fresnel = 0;
  if (any(met.hits.active() && found.surface.fresnel != L(0))) {
    fresnel = dielectric_interface(cosine, L::load(fresnel_eta)).reflectance;
  }
  found.reflected = pov_reflectance(found.surface, color, cosine, fresnel);
  const Rgb<L> passed = pov_passed(found.surface, color);
  found.transmitted =
      select(found.surface.conserves_energy != L(0), passed * pov_rest(found.reflected), passed);
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
  for_lanes<L>(wave.pov_clear, [&](const Entries<L>& hits) {
    const Meeting met(wave, hits);
    const PovHits<L> found = find_pov_hits(wave, met);
    const MaskOf<L> leaves = hits.active() && found.surface.fades != L(0) && !met.enters;
    Rgb<L> left(L(1));
    if (any(leaves)) {
      left = select(leaves, pov_fade(found.surface, hits.of(wave.hits.hit.t)), left);
    }
    const Vectors<L> position(met.position), incident(met.incident),
        mirrored(mirror_direction(met)),
        onward(crossing_direction(met, found.eta, found.interface));
    const Colors<L> reflected(met.weight * left), passed(met.weight * (left * found.transmitted));
    for_each_lane(hits.active(), [&](int k) {
      const std::size_t h = hits[k], parent = met.rays[k];
      if (found.reflects_totally[k]) {
        wave.spawn(true, parent, {position[k], mirrored[k]}, wave.source_at(h, false), reflected[k],
                   static_cast<MediumId>(wave.rays.medium[parent]));
      }
      if (found.interface.total_reflection[k]) return;
      const MediumId behind = found.passage[k].behind;
      const Source source = wave.source_at(h, true);
      if (found.eta[k] == Real(1)) {
        wave.spawn_straight(parent, {position[k], incident[k]}, source, passed[k], behind);
      } else {
        wave.spawn(false, parent, {position[k], onward[k]}, source, passed[k], behind);
      }
    });
  });
}

}  // namespace alhazen::render
