// render/wave: reflection in mirrors, metals and clear coats.
#pragma once

#include "render/surface/fresnel.h"
#include "render/surface/refract.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// The mirror direction about the shading normal, or, where that would lead through the surface,
// about the geometric one.
template <class Real>
Vec3<Real> mirror_direction(const Wave<Real>& wave, std::size_t h) {
  const Vec3<Real> incident = wave.rays.direction[wave.hits.ray_of(h)];
  const Vec3<Real> geometric = wave.hits.geometric_normal[h];
  const Vec3<Real> mirrored = reflected(incident, wave.hits.shading_normal[h]);
  const bool stays = (dot(mirrored, geometric) < Real(0)) != (dot(incident, geometric) < Real(0));
  return stays ? mirrored : reflected(incident, geometric);
}

template <class Real>
void spawn_reflection(Wave<Real>& wave, std::size_t h, Rgb<Real> reflectance) {
  const std::size_t parent = wave.hits.ray_of(h);
  wave.spawn(true, parent, {wave.hits.position[h], mirror_direction(wave, h)},
             wave.source_at(h, false), wave.rays.weight[parent] * reflectance,
             wave.rays.medium[parent]);
}

// The cosine of the angle of incidence against the shading normal, kept within [0, 1].
template <class Real>
Real incident_cosine(const Wave<Real>& wave, std::size_t h) {
  const Real cosine = -dot(wave.rays.direction[wave.hits.ray_of(h)], wave.hits.shading_normal[h]);
  return larger(Real(0), smaller(Real(1), cosine));
}

// The index of refraction that the ray of hit `h` travels in.
template <class Real>
Real incident_ior(const Wave<Real>& wave, std::size_t h) {
  return wave.ior_in(wave.rays.medium[wave.hits.ray_of(h)]);
}

template <class Real>
void reflect_in_mirrors(Wave<Real>& wave) {
  for (const std::size_t h : wave.of(SurfaceKind::mirror))
    spawn_reflection(wave, h, wave.hits.color[h]);
}

template <class Real>
void reflect_in_metals(Wave<Real>& wave) {
  for (const std::size_t h : wave.of(SurfaceKind::metal)) {
    const MaterialRecord<Real>& metal = wave.world.materials[wave.hits.material_of(h)];
    const Real ior = incident_ior(wave, h);
    spawn_reflection(
        wave, h,
        conductor_reflectance(incident_cosine(wave, h), metal.conductor_n, metal.conductor_k, ior));
  }
}

template <class Real>
void reflect_in_coats(Wave<Real>& wave) {
  for (const std::size_t h : wave.of(SurfaceKind::coat)) {
    const CoatLayer<Real>& layer = wave.world.materials[wave.hits.material_of(h)].coat;
    const Real reflectance = coat_mirror_reflectance(layer, incident_cosine(wave, h));
    spawn_reflection(wave, h, Rgb<Real>(reflectance));
  }
}

}  // namespace alhazen::render
