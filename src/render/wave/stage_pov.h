// render/wave: what POV-Ray's finishes do besides answering to lights: they glow by themselves,
// reflect, and let light through (docs/pov_ray.md).
#pragma once

#include "render/surface/pov_finish.h"
#include "render/wave/passage.h"
#include "render/wave/stage_reflect.h"

namespace alhazen::render {

template <class Real>
void add_pov_glow(Wave<Real>& wave) {
  for (const std::uint32_t h : wave.pov_glowing) {
    const PovSurface<Real>& surface = wave.world.materials[wave.hits.material[h]].pov;
    wave.add(wave.hits.ray[h], wave.hits.color[h] * surface.glow);
  }
}

// The surface of hit `h` as a step of the index of refraction.
template <class Real>
struct PovStep {
  Passage<Real> passage;
  DielectricInterface<Real> interface;
};

template <class Real>
PovStep<Real> pov_step(Wave<Real>& wave, std::size_t h) {
  const Hit<Real>& hit = wave.hits.hit[h];
  const MediumId known = wave.rays.medium[wave.hits.ray[h]];
  const MediumId here = wave.world.thin[hit.shape]
                            ? known
                            : before_surface(wave.media, known, wave.hits.material[h], hit.enters);
  PovStep<Real> step{cross_shape(wave.world, wave.media, here, hit.shape, hit.enters), {}};
  step.interface = dielectric_interface(incident_cosine(wave, h),
                                        step.passage.ior_here / step.passage.ior_behind);
  return step;
}

template <class Real>
Rgb<Real> pov_reflectance_at(const Wave<Real>& wave, std::size_t h, const PovStep<Real>& step) {
  return pov_reflectance(wave.world.materials[wave.hits.material[h]].pov, wave.hits.color[h],
                         incident_cosine(wave, h), step.interface.reflectance);
}

// A clear surface that reflects totally does so in transmit_as_pov, and not here as well.
template <class Real>
void reflect_as_pov(Wave<Real>& wave) {
  for (const std::uint32_t h : wave.pov_mirror) {
    const MaterialRecord<Real>& material = wave.world.materials[wave.hits.material[h]];
    const PovStep<Real> step = pov_step(wave, h);
    if (material.pov_clear && step.interface.total_reflection) continue;
    spawn_reflection(wave, h, pov_reflectance_at(wave, h, step));
  }
}

// What has passed a solid is faded on leaving it. A ray that is not bent counts as no deeper one,
// but one that starts where its parent did: however many faces meet there, that has to end.
template <class Real>
void transmit_as_pov(Wave<Real>& wave) {
  for (const std::uint32_t h : wave.pov_clear) {
    const MaterialRecord<Real>& material = wave.world.materials[wave.hits.material[h]];
    const Hit<Real>& hit = wave.hits.hit[h];
    const std::size_t parent = wave.hits.ray[h];
    const Vec3<Real> incident = wave.rays.direction[parent];
    const PovStep<Real> step = pov_step(wave, h);
    Rgb<Real> share(Real(1));
    if (material.pov.fades && !hit.enters) share = pov_fade(material.pov, hit.t);
    if (step.interface.total_reflection) {
      spawn_reflection(wave, h, share);
      continue;
    }
    share = share * pov_passed(material.pov, wave.hits.color[h]);
    if (material.pov.conserves_energy) {
      share = share * pov_rest(pov_reflectance_at(wave, h, step));
    }
    const Real eta = step.passage.ior_here / step.passage.ior_behind;
    const bool unbent = eta == 1;
    Vec3<Real> onward = refracted(incident, wave.hits.shading_normal[h], eta, step.interface);
    const bool crosses = (dot(onward, wave.hits.geometric_normal[h]) < Real(0)) == hit.enters;
    // Smooth normals can bend a ray back; then it goes straight on.
    if (unbent || !crosses) onward = incident;
    wave.spawn(false, parent, {wave.hits.position[h], onward}, wave.source_at(h, true),
               wave.rays.weight[parent] * share, step.passage.behind, unbent && hit.t > Real(0));
  }
}

}  // namespace alhazen::render
