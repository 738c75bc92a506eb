// render/wave: reflection in mirrors, metals and clear coats.
#pragma once

#include "render/surface/fresnel.h"
#include "render/surface/refract.h"
#include "render/wave/spawn.h"

namespace alhazen::render {

// The mirror direction about the shading normal, or, where that would lead through the surface,
// about the geometric one.
template <class L>
Vec3<L> mirror_direction(const Meeting<L>& met) {
  const Vec3<L> mirrored = reflected(met.incident, met.shading_normal);
  const MaskOf<L> comes_below = dot(met.incident, met.geometric_normal) < L(0);
  const MaskOf<L> stays = (dot(mirrored, met.geometric_normal) < L(0)) != comes_below;
  if (all(stays)) return mirrored;
  return select(stays, mirrored, reflected(met.incident, met.geometric_normal));
}

// The cosine of the angle of incidence against the shading normal, kept within [0, 1].
template <class L>
L incident_cosine(const Meeting<L>& met) {
  const L cosine = -dot(met.incident, met.shading_normal);
  return larger(L(0), smaller(L(1), cosine));
}

template <class Real, class L>
Offspring<L> reflection(const Wave<Real>& wave, const Meeting<L>& met, MaskOf<L> exists,
                        const Rgb<L>& reflectance) {
  return {true, exists, mirror_direction(met), met.weight * reflectance,
          met.rays.of(wave.rays.medium)};
}

// Sends on the reflections at the hits of a list; reflectance_at(met) is of each hit.
template <class Real, class ReflectanceAt>
void reflect_hits(Wave<Real>& wave, const IndexList<LaneInt<Real>>& list,
                  const ReflectanceAt& reflectance_at) {
  using L = Wide<Real>;
  Spawner<Real, 1> spawner(wave, list.size());
  for_lanes<L>(list, [&](const Entries<L>& hits) {
    const Meeting<L> met(wave, hits);
    spawner.add(met, {reflection(wave, met, hits.active(), reflectance_at(met))});
  });
}

template <class Real>
void reflect_in_mirrors(Wave<Real>& wave) {
  reflect_hits(wave, wave.of(SurfaceKind::mirror),
               [&](const auto& met) { return met.hits.of(wave.hits.color); });
}

template <class Real>
void reflect_in_metals(Wave<Real>& wave) {
  using L = Wide<Real>;
  reflect_hits(wave, wave.of(SurfaceKind::metal), [&](const Meeting<L>& met) {
    const auto of_metal = [&, id = met.hits.of(wave.hits.material)](auto member) {
      return wave.world.materials.template records_of<L>(member, id, met.hits.active());
    };
    const IntOf<L> medium = met.rays.of(wave.rays.medium);
    L ior(1);
    if (any(met.hits.active() && medium != IntOf<L>(kVacuum))) {
      ior = per_lane<L>(met.hits.active(), Real(1),
                        [&](int k) { return wave.ior_in(static_cast<MediumId>(medium[k])); });
    }
    return conductor_reflectance(incident_cosine(met), of_metal(&MaterialRecord<Real>::conductor_n),
                                 of_metal(&MaterialRecord<Real>::conductor_k), ior);
  });
}

template <class Real>
void reflect_in_coats(Wave<Real>& wave) {
  using L = Wide<Real>;
  reflect_hits(wave, wave.of(SurfaceKind::coat), [&](const Meeting<L>& met) {
    const CoatLayer<L> layer = wave.world.materials.template records_of<L>(
        &MaterialRecord<Real>::coat, met.hits.of(wave.hits.material), met.hits.active());
    return Rgb<L>(coat_mirror_reflectance(layer, incident_cosine(met)));
  });
}

}  // namespace alhazen::render
