// render/wave: what of a light's radiance arrives.
#pragma once

#include "render/surface/absorption.h"
#include "render/wave/stage_glass.h"

namespace alhazen::render {

template <class Real>
void add_unshadowed(Wave<Real>& wave) {
  for (std::size_t i = 0; i < wave.unshadowed.size(); ++i) {
    wave.slots.radiance[wave.unshadowed.slot[i]] += wave.unshadowed.radiance[i];
  }
}

template <class Real>
void count_shadow_rays(Wave<Real>& wave) {
  wave.counters.shadow_rays += wave.light_paths.size();
  for (const SlotId slot : wave.light_paths.slot)
    ++wave.slots.rays[slot];
}

template <class Real>
void add_past_opaque(Wave<Real>& wave) {
  const ShadowQueue<Real>& paths = wave.light_paths;
  count_shadow_rays(wave);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const bool blocked = any_hit(wave.world.shapes, {paths.origin[i], paths.direction[i]},
                                 paths.source[i], paths.distance[i], paths.light_shape[i]);
    if (!blocked) wave.slots.radiance[paths.slot[i]] += paths.radiance[i];
  }
}

// The share of light that a surface of glass lets through on a straight path. The path is not bent,
// so its angle is the one outside of the glass, and Fresnel's equations are read from the side of
// the lower index on both faces: exact for a pane, and no false total reflection inside of a ball.
template <class Real>
Real straight_transmission(const Passage<Real>& passage, Real cosine) {
  const Real lower = smaller(passage.ior_here, passage.ior_behind);
  const Real higher = larger(passage.ior_here, passage.ior_behind);
  return dielectric_interface(cosine, lower / higher).transmittance;
}

// Follows one path through every surface between the point and the light; what arrives of 1. The
// path is one straight line: its hits are visited in their order on it, and nothing starts anew.
template <class Real>
Rgb<Real> follow_to_light(Wave<Real>& wave, std::size_t i) {
  const ShadowQueue<Real>& paths = wave.light_paths;
  const World<Real>& world = wave.world;
  const Ray<Real> ray{paths.origin[i], paths.direction[i]};
  const Source& source = paths.source[i];
  const Real distance = paths.distance[i];
  const ShapeId lamp = paths.light_shape[i];
  MediumId medium = paths.medium[i];
  Real travelled = 0;
  Rgb<Real> share(Real(1));
  auto hit = closest_hit(world.shapes, ray, source, distance, lamp);
  for (; !is_black(share); hit = next_hit(world.shapes, ray, source, *hit, distance, lamp)) {
    const Real here = hit ? hit->t : distance;
    const MaterialId material = hit ? world.material_of[hit->shape] : kNoId;
    if (hit) {
      if (world.materials[material].kind != SurfaceKind::glass) return Rgb<Real>{};
      medium = before_surface(wave.media, medium, material, hit->enters);
    }
    const MaterialId inside = wave.media.current(medium, world.materials.priorities());
    if (inside != kNoId) {
      share = share * transmitted_share(world.materials[inside].absorption, here - travelled);
    }
    if (!hit) break;
    const Passage<Real> passage = cross_surface(world, wave.media, medium, material, hit->enters);
    if (passage.is_interface) {
      const SurfacePoint<Real> point = world.shapes.plain_surface(hit->shape, ray, hit->crossing());
      share = straight_transmission(passage, absolute(dot(ray.direction, point.normal))) * share;
    }
    medium = passage.behind;
    travelled = here;
  }
  return share;
}

template <class Real>
void add_through_glass(Wave<Real>& wave) {
  count_shadow_rays(wave);
  for (std::size_t i = 0; i < wave.light_paths.size(); ++i) {
    wave.slots.radiance[wave.light_paths.slot[i]] +=
        wave.light_paths.radiance[i] * follow_to_light(wave, i);
  }
}

}  // namespace alhazen::render
