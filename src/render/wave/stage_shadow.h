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
  if (wave.slots.rays.empty()) return;
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
Real straight_transmission(Real ior_here, Real ior_behind, Real cosine) {
  const Real lower = smaller(ior_here, ior_behind), higher = larger(ior_here, ior_behind);
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

// How far a path to a light has come: it has met `hit`, or nothing more.
template <class Real>
struct LightPath {
  std::optional<Hit<Real>> hit;
  MediumId medium;
  Real travelled;
  Rgb<Real> share;  // of the light that is left
};

// Follows one path through every surface up to the light; what arrives of 1. The path is one
// straight line: its hits are visited in their order on it, and nothing starts anew.
template <class Real>
Rgb<Real> follow_alone(Wave<Real>& wave, std::size_t i, LightPath<Real> path) {
  const ShadowQueue<Real>& paths = wave.light_paths;
  const World<Real>& world = wave.world;
  const Ray<Real> ray{paths.origin[i], paths.direction[i]};
  const Source source = paths.source[i];
  const Real distance = paths.distance[i];
  const auto lamp = static_cast<ShapeId>(paths.light_shape[i]);
  auto& [hit, medium, travelled, share] = path;
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
      share = straight_transmission(passage.ior_here, passage.ior_behind,
                                    absolute(dot(ray.direction, point.normal))) *
              share;
    }
    medium = passage.behind;
    travelled = here;
  }
  return share;
}

// The same for several paths, from what they have met first. They go together while what they cross
// is plain; one that is not goes on alone.
template <class L>
Rgb<L> follow_to_light(Wave<ScalarOf<L>>& wave, const Entries<L>& at, HitLanes<L> hit) {
  using Real = ScalarOf<L>;
  using Int = IntOf<L>;
  using Mask = MaskOf<L>;
  const ShadowQueue<Real>& paths = wave.light_paths;
  const World<Real>& world = wave.world;
  const Ray<L> ray = rays_at(paths, at);
  const L distance = at.of(paths.distance);
  Int medium = at.of(paths.medium);
  L travelled(0);
  Rgb<L> share(L(1));
  for (Mask under_way = at.active();;) {
    const Mask met = under_way && hit.found;
    const Int material = world.template materials_at<L>(hit.shape, met);
    const Int way = world.materials.template ways_of<L>(material, met);
    const Mask ends = met && way == Int(static_cast<int>(Way::ends));
    share = select(ends, Rgb<L>(L(0)), share);
    const Mask is_glass = met && way == Int(static_cast<int>(Way::through_glass));
    const PlainPassage<L> plain(world, medium, material, hit.enters, is_glass);
    const Mask alone = met && !ends && !plain.is;
    for_each_lane(alone, [&](int k) {
      const Rgb<Real> arrives =
          follow_alone<Real>(wave, at[k],
                             {hit[k], static_cast<MediumId>(medium[k]), travelled[k],
                              Rgb<Real>(share.r[k], share.g[k], share.b[k])});
      share.r.set(k, arrives.r);
      share.g.set(k, arrives.g);
      share.b.set(k, arrives.b);
    });
    under_way = under_way && !ends && !alone;
    if (!any(under_way)) return share;
    const L here = select(hit.found, hit.t, distance);
    share = share * share_left(wave, medium, here - travelled, under_way);
    if (!any(plain.is)) return share;
    const SurfacePoint<L> point = world.shapes.template plain_surface<L>(
        hit.shape, ray, Crossing<L>{hit.t, hit.face, hit.enters}, plain.is);
    const L passes = straight_transmission(plain.ior_here, plain.ior_behind,
                                           absolute(dot(ray.direction, point.normal)));
    share = select(plain.is, passes * share, share);
    medium = plain.behind;
    travelled = here;
    under_way = plain.is && !is_black(share);
    if (!any(under_way)) return share;
    hit = next_hits(
        world.tree, ray, paths.source.departures(at),
        [&](int lane) { return paths.source[at[lane]]; }, hit, distance, at.of(paths.light_shape),
        under_way);
  }
}

template <class Real>
void add_through_glass(Wave<Real>& wave) {
  using L = Wide<Real>;
  const ShadowQueue<Real>& paths = wave.light_paths;
  count_shadow_rays(wave);
  for_lanes<L>(paths.size(), [&](const Entries<L>& at) {
    const HitLanes<L> first = closest_hits(
        wave.world.tree, rays_at(paths, at), paths.source.departures(at),
        [&](int lane) { return paths.source[at[lane]]; }, at.of(paths.distance),
        at.of(paths.light_shape), at.active());
    const Colors<L> arrives(at.of(paths.radiance) * follow_to_light(wave, at, first));
    for_each_lane(at.active(),
                  [&](int k) { wave.slots.radiance[paths.slot[at[k]]] += arrives[k]; });
  });
}

}  // namespace alhazen::render
