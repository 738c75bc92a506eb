// render/wave: reflection and refraction at the interfaces of dielectrics. Surfaces that are no
// interface have been passed already, when hits were found (stage_hits.h).
#pragma once

#include "render/wave/passage.h"
#include "render/wave/stage_reflect.h"

namespace alhazen::render {

template <class Real>
void refract_in_glass(Wave<Real>& wave) {
  for (const std::size_t h : wave.of(SurfaceKind::glass)) {
    const std::size_t parent = wave.hits.ray_of(h);
    const Vec3<Real> incident = wave.rays.direction[parent];
    const Vec3<Real> position = wave.hits.position[h];
    const bool entering = wave.hits.hit[h].enters;
    const Passage<Real> passage = cross_surface(wave.world, wave.media, wave.rays.medium[parent],
                                                wave.hits.material_of(h), entering);
    const Rgb<Real> weight = wave.rays.weight[parent];
    const Real eta = passage.ior_here / passage.ior_behind;
    const DielectricInterface<Real> interface = dielectric_interface(incident_cosine(wave, h), eta);
    spawn_reflection(wave, h, Rgb<Real>(interface.reflectance));
    if (interface.total_reflection) continue;
    Vec3<Real> onward = refracted(incident, wave.hits.shading_normal[h], eta, interface);
    const bool crosses = (dot(onward, wave.hits.geometric_normal[h]) < Real(0)) == entering;
    // Smooth normals can bend a ray back; then it goes straight on.
    if (!crosses) onward = incident;
    wave.spawn(false, parent, {position, onward}, wave.source_at(h, true),
               interface.transmittance * weight, passage.behind);
  }
}

}  // namespace alhazen::render
