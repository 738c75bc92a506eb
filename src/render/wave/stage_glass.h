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
    std::array<MediumId, L::kWidth> behind{};
    const L eta = per_lane<L>(hits.active(), Real(1), [&](int k) {
      const std::size_t h = hits[k];
      const Passage<Real> passage =
          cross_surface(wave.world, wave.media, wave.rays.medium[met.rays[k]],
                        wave.hits.material_of(h), wave.hits.hit.enters[h] != 0);
      behind[static_cast<std::size_t>(k)] = passage.behind;
      return passage.ior_here / passage.ior_behind;
    });
    const DielectricInterface<L> interface = dielectric_interface(incident_cosine(met), eta);
    const Offspring<L> passing{false, hits.active() && !interface.total_reflection,
                               crossing_direction(met, eta, interface),
                               interface.transmittance * met.weight, behind};
    spawn(wave, met,
          std::array{reflection(wave, met, hits.active(), Rgb<L>(interface.reflectance)), passing});
  });
}

}  // namespace alhazen::render
