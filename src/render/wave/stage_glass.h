// render/wave: reflection and refraction at the surfaces of nested dielectrics.
#pragma once

#include "render/wave/stage_reflect.h"

namespace alhazen::render {

// What a ray crosses at a surface of a dielectric solid.
template <class Real>
struct Passage {
  MediumId behind;    // the solids it is in beyond the surface
  bool is_interface;  // false where a solid of higher priority, or the same material, fills both
                      // sides
  Real ior_here, ior_behind;
};

// `entering`: the ray goes against the outward normal. A ray that leaves a solid it was not known
// to be in (its surface is open, or the camera stood in an open shape) has been in that solid all
// along.
template <class Real>
Passage<Real> cross_surface(const World<Real>& world, MediumPool& media, MediumId here,
                            MaterialId material, bool entering) {
  const auto& priority = world.materials.priorities();
  if (!entering && !media.contains(here, material)) here = media.enter(here, material);
  const MediumId behind = entering ? media.enter(here, material) : media.leave(here, material);
  const MaterialId from = media.current(here, priority), to = media.current(behind, priority);
  return {behind, from != to, world.ior_of(from), world.ior_of(to)};
}

template <class Real>
void refract_in_glass(Wave<Real>& wave) {
  for (const std::uint32_t h : wave.glass) {
    const std::size_t parent = wave.hits.ray[h];
    const Vec3<Real> incident = wave.rays.direction[parent];
    const Vec3<Real> position = wave.hits.position[h];
    const bool entering = wave.hits.hit[h].enters;
    const Passage<Real> passage = cross_surface(wave.world, wave.media, wave.rays.medium[parent],
                                                wave.hits.material[h], entering);
    const Rgb<Real> weight = wave.rays.weight[parent];
    if (!passage.is_interface) {
      wave.spawn(false, parent, {position, incident}, wave.source_at(h, true), weight,
                 passage.behind, 0);
      continue;
    }
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
