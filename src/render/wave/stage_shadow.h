// render/wave: what of a light's radiance arrives.
#pragma once

#include "render/accel/shape_tree_lanes.h"
#include "render/surface/absorption.h"
#include "render/wave/stage_glass.h"
#include "render/wave/stage_hits.h"

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
  for (std::size_t i = 0; i < wave.light_paths.size(); ++i)
    ++wave.slots.rays[wave.light_paths.slot[i]];
}

template <class L>
Ray<L> rays_at(const ShadowQueue<ScalarOf<L>>& paths, const Entries<L>& at) {
  return {at.of(paths.origin), at.of(paths.direction)};
}

template <class Real>
void add_past_opaque(Wave<Real>& wave) {
  using L = Wide<Real>;
  const ShadowQueue<Real>& paths = wave.light_paths;
  count_shadow_rays(wave);
  for_lanes<L>(paths.size(), [&](const Entries<L>& at) {
    const MaskOf<L> blocked = any_hits(
        wave.world.tree, rays_at(paths, at), paths.source.departures(at),
        [&](int lane) { return paths.source[at[lane]]; }, at.of(paths.distance),
        at.of(paths.light_shape), at.active());
    for_each_lane(at.active() && !blocked, [&](int k) {
      const std::size_t i = at[k];
      wave.slots.radiance[paths.slot[i]] += paths.radiance[i];
    });
  });
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

// The share that a clear surface of POV-Ray's model lets through on a straight path, and what has
// been lost on the way to it inside of its solid.
template <class Real>
Rgb<Real> pov_shadow(const World<Real>& world, const Ray<Real>& ray, const Hit<Real>& hit,
                     Real distance) {
  const MaterialRecord<Real>& material = world.materials[world.material_of[hit.shape]];
  const auto solid = world.textures.solid_color(material.color);
  Rgb<Real> share;
  if (solid) {
    share = pov_passed(material.pov, *solid);
  } else {
    const SurfacePoint<Real> p = world.shapes.surface(hit.shape, ray, hit.crossing());
    const TexturePoint<Real> at{p.object_position, p.position, p.u, p.v};
    share = pov_passed(material.pov, world.textures.color(material.color, at));
  }
  const bool leaves = material.pov.fades && !hit.enters;
  return leaves ? share * pov_fade(material.pov, distance) : share;
}

// Follows one path through every surface between the point and the light, from the first `hit` on;
// what arrives of 1. The path is one straight line: its hits are visited in their order on it, and
// nothing starts anew.
template <class Real>
Rgb<Real> follow_to_light(Wave<Real>& wave, std::size_t i, std::optional<Hit<Real>> hit) {
  const ShadowQueue<Real>& paths = wave.light_paths;
  const World<Real>& world = wave.world;
  const Ray<Real> ray{paths.origin[i], paths.direction[i]};
  const Source source = paths.source[i];
  const Real distance = paths.distance[i];
  const auto lamp = static_cast<ShapeId>(paths.light_shape[i]);
  MediumId medium = paths.medium[i];
  Real travelled = 0;
  Rgb<Real> share(Real(1));
  for (; !is_black(share); hit = next_hit(world.tree, ray, source, *hit, distance, lamp)) {
    const Real here = hit ? hit->t : distance;
    const MaterialId material = hit ? world.material_of[hit->shape] : kNoId;
    const bool is_pov = hit && world.materials[material].pov_clear;
    if (hit) {
      if (!is_pov && world.materials[material].kind != SurfaceKind::glass) return Rgb<Real>{};
      if (!world.thin[hit->shape]) {
        medium = before_surface(wave.media, medium, material, hit->enters);
      }
    }
    const MaterialId inside = wave.media.current(medium, world.materials.priorities());
    if (inside != kNoId) {
      share = share * transmitted_share(world.materials[inside].absorption, here - travelled);
    }
    if (!hit) break;
    const Passage<Real> passage = cross_shape(world, wave.media, medium, hit->shape, hit->enters);
    if (is_pov) {
      share = share * pov_shadow(world, ray, *hit, here - travelled);
    } else if (passage.is_interface) {
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
  using L = Wide<Real>;
  const ShadowQueue<Real>& paths = wave.light_paths;
  count_shadow_rays(wave);
  for_lanes<L>(paths.size(), [&](const Entries<L>& at) {
    const HitNumbers<L> first(closest_hits(
        wave.world.tree, rays_at(paths, at), paths.source.departures(at),
        [&](int lane) { return paths.source[at[lane]]; }, at.of(paths.distance),
        at.of(paths.light_shape), at.active()));
    for_each_lane(at.active(), [&](int k) {
      const std::size_t i = at[k];
      wave.slots.radiance[paths.slot[i]] += paths.radiance[i] * follow_to_light(wave, i, first[k]);
    });
  });
}

}  // namespace alhazen::render
