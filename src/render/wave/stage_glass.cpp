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

template <class Real>
void refract_in_glass(Wave<Real>& wave) {
  using L = Wide<Real>;
  Spawner<Real, 2> spawner(wave, wave.of(SurfaceKind::glass).size());
  for_lanes<L>(wave.of(SurfaceKind::glass), [&](const Entries<L>& hits) {
    const Meeting<L> met(wave, hits);
    const PassageLanes<L> passage =
        cross_shapes<L>(wave, met.rays.of(wave.rays.medium), hits.of(wave.hits.hit.shape),
                        hits.of(wave.hits.material), met.enters, hits.active());
    const L eta = passage.ior_here / passage.ior_behind;
    const DielectricInterface<L> interface = dielectric_interface(incident_cosine(met), eta);
    const Offspring<L> passing{false, hits.active() && !interface.total_reflection,
                               crossing_direction(met, eta, interface),
                               interface.transmittance * met.weight, passage.behind};
    spawner.add(met,
                {reflection(wave, met, hits.active(), Rgb<L>(interface.reflectance)), passing});
  });
}

}  // namespace alhazen::render
