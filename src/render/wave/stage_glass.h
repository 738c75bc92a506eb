// render/wave: reflection and refraction at the interfaces of dielectrics. Surfaces that are no
// interface have been passed already, when hits were found (stage_hits.h).
#pragma once

#include <array>

#include "render/wave/passage.h"
#include "render/wave/stage_reflect.h"

namespace alhazen::render {

// Where rays go on that cross a surface. Smooth normals can bend a ray back; then it goes straight
// on.
template <class L>
Vec3<L> crossing_direction(const Meeting<L>& met, L eta, const DielectricInterface<L>& interface) {
  const Vec3<L> onward = refracted(met.incident, met.shading_normal, eta, interface);
  const MaskOf<L> crosses = (dot(onward, met.geometric_normal) < L(0)) == met.enters;
  return select(crosses, onward, met.incident);
}

// The rays of each hit stand together: first the reflected one.
template <class Real>
void refract_in_glass(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.of(SurfaceKind::glass), [&](const Entries<L>& hits) {
    const Meeting met(wave, hits);
    std::array<MediumId, L::kWidth> here, behind;
    const L eta = per_lane<L>(hits.active(), Real(1), [&](int k) {
      const std::size_t h = hits[k];
      here[k] = wave.rays.medium[met.rays[k]];
      const Passage<Real> passage =
          cross_surface(wave.world, wave.media, here[k], wave.hits.material_of(h), met.enters[k]);
      behind[k] = passage.behind;
      return passage.ior_here / passage.ior_behind;
    });
    const DielectricInterface<L> interface = dielectric_interface(incident_cosine(met), eta);
    const Vectors<L> position(met.position), mirrored(mirror_direction(met)),
        onward(crossing_direction(met, eta, interface));
    const Colors<L> reflected(met.weight * Rgb<L>(interface.reflectance)),
        passed(interface.transmittance * met.weight);
    for_each_lane(hits.active(), [&](int k) {
      const std::size_t h = hits[k], parent = met.rays[k];
      wave.spawn(true, parent, {position[k], mirrored[k]}, wave.source_at(h, false), reflected[k],
                 here[k]);
      if (interface.total_reflection[k]) return;
      wave.spawn(false, parent, {position[k], onward[k]}, wave.source_at(h, true), passed[k],
                 behind[k]);
    });
  });
}

}  // namespace alhazen::render
