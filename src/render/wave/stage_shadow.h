// render/wave: what of a light's radiance arrives.
#pragma once

#include "render/accel/shape_tree_lanes.h"
#include "render/surface/absorption.h"
#include "render/wave/stage_glass.h"
#include "render/wave/stage_hits.h"

namespace alhazen::render {

// Several light paths of the generation.
template <class L>
struct LightPaths {
  using Real = ScalarOf<L>;

  LightPaths(const Wave<Real>& wave_, const ShadowQueue<Real>& paths, const Entries<L>& at)
      : wave(wave_),
        hits(at.of(paths.hit), at.active()),
        rays(hits.of(wave.hits.ray), at.active()),
        active(at.active()),
        ray{hits.of(wave.hits.position), at.of(paths.direction)},
        distance(at.of(paths.distance)),
        lamp(at.of(paths.light_shape)),
        radiance(at.of(paths.radiance)) {
    const MaskOf<L> above = hits.of(wave.hits.hit.enters) != IntOf<L>(0);
    from = {hits.of(wave.hits.hit.shape), hits.of(wave.hits.hit.face),
            select(above, IntOf<L>(static_cast<int>(Side::kAbove)),
                   IntOf<L>(static_cast<int>(Side::kBelow)))};
  }
  Source source_of(int lane) const { return wave.source_at(hits[lane], false); }

  const Wave<Real>& wave;
  Entries<L> hits, rays;  // where they start, and what came there
  MaskOf<L> active;
  Ray<L> ray;
  L distance;
  IntOf<L> lamp;
  Rgb<L> radiance;
  DepartureLanes<L> from;
};

template <class Real>
void count_shadow_rays(Wave<Real>& wave) {
  const ShadowQueue<Real>& paths = wave.light_paths;
  wave.counters.shadow_rays += paths.size();
  if (wave.slots.rays.empty()) return;
  for (std::size_t i = 0; i < paths.size(); ++i)
    ++wave.slots.rays[wave.slot_of_hit(static_cast<std::size_t>(paths.hit[i]))];
}

// Adds radiance to the samples of the paths, in their order.
template <class L>
void add_arrived(Wave<ScalarOf<L>>& wave, const LightPaths<L>& paths, MaskOf<L> which,
                 const Rgb<L>& radiance) {
  const Colors<L> arrived(radiance);
  const Numbers<IntOf<L>> slot(paths.rays.of(wave.rays.slot));
  for_each_lane(which, [&](int k) { wave.slots.radiance[slot[k]] += arrived[k]; });
}

template <class Real>
void add_unshadowed(Wave<Real>& wave) {
  using L = Wide<Real>;
  for_lanes<L>(wave.unshadowed.size(), [&](const Entries<L>& at) {
    const LightPaths<L> paths(wave, wave.unshadowed, at);
    add_arrived(wave, paths, paths.active, paths.radiance);
  });
}

template <class Real>
void add_past_opaque(Wave<Real>& wave) {
  using L = Wide<Real>;
  count_shadow_rays(wave);
  for_lanes<L>(wave.light_paths.size(), [&](const Entries<L>& at) {
    const LightPaths<L> paths(wave, wave.light_paths, at);
    const MaskOf<L> blocked = any_hits(
        wave.world.tree, paths.ray, paths.from, [&](int lane) { return paths.source_of(lane); },
        paths.distance, paths.lamp, paths.active);
    add_arrived(wave, paths, paths.active && !blocked, paths.radiance);
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
template <class L>
Rgb<ScalarOf<L>> follow_alone(Wave<ScalarOf<L>>& wave, const LightPaths<L>& paths, int lane,
                              LightPath<ScalarOf<L>> path) {
  using Real = ScalarOf<L>;
  const World<Real>& world = wave.world;
  const Ray<Real> ray = one_ray(paths.ray, lane);
  const Source source = paths.source_of(lane);
  const Real distance = paths.distance[lane];
  const auto lamp = static_cast<ShapeId>(paths.lamp[lane]);
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
Rgb<L> follow_to_light(Wave<ScalarOf<L>>& wave, const LightPaths<L>& paths, HitLanes<L> hit) {
  using Real = ScalarOf<L>;
  using Int = IntOf<L>;
  using Mask = MaskOf<L>;
  const World<Real>& world = wave.world;
  Int medium = paths.rays.of(wave.rays.medium);
  L travelled(0);
  Rgb<L> share(L(1));
  for (Mask under_way = paths.active;;) {
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
          follow_alone(wave, paths, k,
                       {hit[k], static_cast<MediumId>(medium[k]), travelled[k],
                        Rgb<Real>(share.r[k], share.g[k], share.b[k])});
      share.r.set(k, arrives.r);
      share.g.set(k, arrives.g);
      share.b.set(k, arrives.b);
    });
    under_way = under_way && !ends && !alone;
    if (!any(under_way)) return share;
    const L here = select(hit.found, hit.t, paths.distance);
    share = share * share_left(wave, medium, here - travelled, under_way);
    if (!any(plain.is)) return share;
    const SurfacePoint<L> point = world.shapes.template plain_surface<L>(
        hit.shape, paths.ray, Crossing<L>{hit.t, hit.face, hit.enters}, plain.is);
    const L passes = straight_transmission(plain.ior_here, plain.ior_behind,
                                           absolute(dot(paths.ray.direction, point.normal)));
    share = select(plain.is, passes * share, share);
    medium = plain.behind;
    travelled = here;
    under_way = plain.is && !is_black(share);
    if (!any(under_way)) return share;
    hit = next_hits(
        world.tree, paths.ray, paths.from, [&](int lane) { return paths.source_of(lane); }, hit,
        paths.distance, paths.lamp, under_way);
  }
}

template <class Real>
void add_through_glass(Wave<Real>& wave) {
  using L = Wide<Real>;
  count_shadow_rays(wave);
  for_lanes<L>(wave.light_paths.size(), [&](const Entries<L>& at) {
    const LightPaths<L> paths(wave, wave.light_paths, at);
    const HitLanes<L> first = closest_hits(
        wave.world.tree, paths.ray, paths.from, [&](int lane) { return paths.source_of(lane); },
        paths.distance, paths.lamp, paths.active);
    add_arrived(wave, paths, paths.active, paths.radiance * follow_to_light(wave, paths, first));
  });
}

}  // namespace alhazen::render
