// render/wave: what POV-Ray's finishes do besides answering to lights: they glow by themselves,
// reflect, and let light through (docs/pov_ray.md).
#pragma once

#include "render/surface/pov_finish.h"
#include "render/wave/passage.h"
#include "render/wave/stage_reflect.h"

namespace alhazen::render {

template <class Real>
void add_pov_glow(Wave<Real>& wave) {
  for (const std::size_t h : wave.pov_glowing) {
    const PovSurface<Real>& surface = wave.world.materials[wave.hits.material_of(h)].pov;
    wave.add(wave.hits.ray_of(h), wave.hits.color[h] * surface.glow);
  }
}

// A hit on a finish that reflects or is clear.
template <class Real>
struct PovHit {
  Passage<Real> passage;
  DielectricInterface<Real> interface;
  Rgb<Real> reflected;    // the part that is
  Rgb<Real> transmitted;  // the part that is, if there is no total reflection
  // Total reflection takes the place of the other, but only where light would pass: POV-Ray does
  // not look for it where `conserve_energy` has left nothing.
  bool reflects_totally;
};

// Index of this side over that of the other, as a `fresnel` reflection goes by it. On leaving one
// solid of several it is not the one that rays are bent by: POV-Ray 3.7 takes the solid entered
// last for the other side, also where that is the one being left.
template <class Real>
Real pov_fresnel_eta(const Passage<Real>& passage, Real own, bool entering) {
  if (entering) return passage.ior_here / own;
  return passage.behind == kVacuum ? own : own / passage.ior_here;
}

// An opaque surface that is met from behind, by a ray that is not known to be inside of it, is the
// back of a sheet: POV-Ray takes either side of a sheet for the outside.
template <class Real>
PovHit<Real> find_pov_hit(Wave<Real>& wave, std::size_t h) {
  const Hit<Real> hit = wave.hits.hit[h];
  const MaterialId id = wave.hits.material_of(h);
  const MaterialRecord<Real>& material = wave.world.materials[id];
  const Real cosine = incident_cosine(wave, h);
  MediumId here = wave.rays.medium[wave.hits.ray_of(h)];
  const bool enters = hit.enters || (!material.pov_clear && !wave.media.contains(here, id));
  if (!wave.world.thin[hit.shape]) here = before_surface(wave.media, here, id, enters);
  PovHit<Real> met{};
  met.passage = cross_shape(wave.world, wave.media, here, hit.shape, enters);
  met.interface = dielectric_interface(cosine, met.passage.ior_here / met.passage.ior_behind);
  Real fresnel = 0;
  if (material.pov.fresnel) {
    const Real eta = pov_fresnel_eta(met.passage, material.ior, enters);
    fresnel = dielectric_interface(cosine, eta).reflectance;
  }
  met.reflected = pov_reflectance(material.pov, wave.hits.color[h], cosine, fresnel);
  met.transmitted = pov_passed(material.pov, wave.hits.color[h]);
  if (material.pov.conserves_energy) met.transmitted = met.transmitted * pov_rest(met.reflected);
  met.reflects_totally = met.interface.total_reflection && !is_black(met.transmitted);
  return met;
}

template <class Real>
void reflect_as_pov(Wave<Real>& wave) {
  for (const std::size_t h : wave.pov_mirror) {
    const PovHit<Real> met = find_pov_hit(wave, h);
    if (!met.reflects_totally) spawn_reflection(wave, h, met.reflected);
  }
}

// What has passed a solid is faded on leaving it. A ray that is not bent counts as no deeper one.
template <class Real>
void transmit_as_pov(Wave<Real>& wave) {
  for (const std::size_t h : wave.pov_clear) {
    const PovSurface<Real>& surface = wave.world.materials[wave.hits.material_of(h)].pov;
    const Hit<Real> hit = wave.hits.hit[h];
    const std::size_t parent = wave.hits.ray_of(h);
    const Vec3<Real> incident = wave.rays.direction[parent];
    const PovHit<Real> met = find_pov_hit(wave, h);
    const bool leaves = surface.fades && !hit.enters;
    const Rgb<Real> left = leaves ? pov_fade(surface, hit.t) : Rgb<Real>(Real(1));
    if (met.reflects_totally) spawn_reflection(wave, h, left);
    if (met.interface.total_reflection) continue;
    const Real eta = met.passage.ior_here / met.passage.ior_behind;
    const Rgb<Real> weight = wave.rays.weight[parent] * (left * met.transmitted);
    const Source source = wave.source_at(h, true);
    if (eta == 1) {
      wave.spawn_straight(parent, {wave.hits.position[h], incident}, source, weight,
                          met.passage.behind);
      continue;
    }
    Vec3<Real> onward = refracted(incident, wave.hits.shading_normal[h], eta, met.interface);
    const bool crosses = (dot(onward, wave.hits.geometric_normal[h]) < Real(0)) == hit.enters;
    // Smooth normals can bend a ray back; then it goes straight on.
    if (!crosses) onward = incident;
    wave.spawn(false, parent, {wave.hits.position[h], onward}, source, weight, met.passage.behind);
  }
}

}  // namespace alhazen::render
