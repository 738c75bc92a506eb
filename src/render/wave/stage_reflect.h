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
  Offspring<L> rays{true, exists, mirror_direction(met), met.weight * reflectance, {}};
  for_each_lane(exists, [&](int k) {
    rays.medium[static_cast<std::size_t>(k)] = wave.rays.medium[met.rays[k]];
  });
  return rays;
}

template <class Real, class L>
void spawn_reflections(Wave<Real>& wave, const Meeting<L>& met, MaskOf<L> which,
                       const Rgb<L>& reflectance) {
  spawn(wave, met, std::array{reflection(wave, met, which, reflectance)});
}

template <class Real>
void reflect_in_mirrors(Wave<Real>& wave) {
  for_lanes<Wide<Real>>(wave.of(SurfaceKind::mirror), [&](const Entries<Wide<Real>>& hits) {
    spawn_reflections(wave, Meeting(wave, hits), hits.active(), hits.of(wave.hits.color));
  });
}

template <class Real>
void reflect_in_metals(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.of(SurfaceKind::metal), [&](const Entries<L>& hits) {
    const Meeting met(wave, hits);
    const auto of_metal = [&, id = hits.of(wave.hits.material)](auto member) {
      return wave.world.materials.template records_of<L>(member, id, hits.active());
    };
    const L ior = per_lane<L>(hits.active(), Real(1),
                              [&](int k) { return wave.ior_in(wave.rays.medium[met.rays[k]]); });
    spawn_reflections(
        wave, met, hits.active(),
        conductor_reflectance(incident_cosine(met), of_metal(&MaterialRecord<Real>::conductor_n),
                              of_metal(&MaterialRecord<Real>::conductor_k), ior));
  });
}

template <class Real>
void reflect_in_coats(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.of(SurfaceKind::coat), [&](const Entries<L>& hits) {
    const Meeting met(wave, hits);
    const CoatLayer<L> layer = wave.world.materials.template records_of<L>(
        &MaterialRecord<Real>::coat, hits.of(wave.hits.material), hits.active());
    spawn_reflections(wave, met, hits.active(),
                      Rgb<L>(coat_mirror_reflectance(layer, incident_cosine(met))));
  });
}

}  // namespace alhazen::render
