// render/wave: the stage of light that passes clear things.
#include "render/surface/absorption.h"
#include "render/surface/fresnel.h"
#include "render/wave/light_paths.h"
#include "render/wave/passage.h"
#include "render/wave/stage_home.h"
#include "render/wave/surface_color.h"

namespace alhazen::render {

// The share of light that a surface of glass lets through on a straight path. The path is not bent,
// so its angle is the one outside of the glass, and Fresnel's equations are read from the side of
// the lower index on both faces: exact for a pane, and no false total reflection inside of a ball.
template <class Real>
Real straight_transmission(Real ior_here, Real ior_behind, Real cosine) {
  const Real lower = smaller(ior_here, ior_behind), higher = larger(ior_here, ior_behind);
  return dielectric_interface(cosine, lower / higher).transmittance;
}

// The share that clear surfaces of POV-Ray's model let through on straight paths, and what has been
// lost on the way to them inside of their solids.
template <class L>
Rgb<L> pov_shadow(const World<ScalarOf<L>>& world, const Ray<L>& ray, const HitLanes<L>& hit,
                  const IntOf<L>& material, const L& distance, MaskOf<L> which) {
  using Real = ScalarOf<L>;
  const auto texture_points = [&](MaskOf<L> asks) {
    const SurfacePoint<L> p = world.shapes.template surface<L>(
        hit.shape, ray, Crossing<L>{hit.t, hit.face, hit.enters}, asks);
    return TexturePoint<L>{p.object_position, p.position, p.u, p.v};
  };
  const Rgb<L> color = surface_colors<L, is_built_here(Effect::image_textures)>(
      world, material, which, texture_points);
  const auto of_material = [&](auto member) {
    return world.materials.template records_of<L>(member, material, which);
  };
  const PovPassage<L> passage = of_material(&MaterialRecord<Real>::pov_passage);
  const Rgb<L> share = pov_passed(passage, color);
  const MaskOf<L> fades = which && passage.fades != L(0) && !hit.enters;
  if (!any(fades)) return share;
  const PovFading<L> fading = of_material(&MaterialRecord<Real>::pov_fading);
  return select(fades, share * pov_fade(fading, distance), share);
}

// Follows paths through every surface up to the light, from what they have met first; what arrives
// of 1. Each path is one straight line: its hits are visited in their order on it, and nothing
// starts anew.
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
    const Mask is_clear = met && way == Int(static_cast<int>(Way::through_clear));
    share = select(ends, Rgb<L>(L(0)), share);
    under_way = under_way && !ends;
    if (!any(under_way)) return share;
    const Mask passes = met && !ends;
    const PassageLanes<L> passage =
        cross_shapes<L>(wave, medium, hit.shape, material, hit.enters, passes);
    const L here = select(hit.found, hit.t, paths.distance);
    share = share * share_left(wave, passage.here, here - travelled, under_way);
    if (!any(passes)) return share;
    if (any(is_clear)) {
      const Rgb<L> left = pov_shadow(world, paths.ray, hit, material, here - travelled, is_clear);
      share = select(is_clear, share * left, share);
    }
    if (const Mask bends = passage.is_interface && !is_clear; any(bends)) {
      const SurfacePoint<L> point = world.shapes.template plain_surface<L>(
          hit.shape, paths.ray, Crossing<L>{hit.t, hit.face, hit.enters}, bends);
      const L passed = straight_transmission(passage.ior_here, passage.ior_behind,
                                             absolute(dot(paths.ray.direction, point.normal)));
      share = select(bends, passed * share, share);
    }
    medium = passage.behind;
    travelled = here;
    under_way = passes && !is_black(share);
    if (!any(under_way)) return share;
    hit = next_hits(
        world.tree, paths.ray, paths.from, [&](int lane) { return paths.source_of(lane); }, hit,
        paths.distance, paths.lamp, under_way);
  }
}

template <class Real>
void add_through_glass(Wave<Real>& wave) {
  using L = Packet<Real>;
  count_shadow_rays(wave);
  for_lanes<L>(wave.light_paths.size(), [&](const Entries<L>& at) {
    const LightPaths<L> paths(wave, wave.light_paths, at);
    const HitLanes<L> first = closest_hits(
        wave.world.tree, paths.ray, paths.from, [&](int lane) { return paths.source_of(lane); },
        paths.distance, paths.lamp, paths.active);
    add_arrived(wave, paths.rays, paths.active,
                paths.radiance * follow_to_light(wave, paths, first));
  });
}

template struct StagesOf<StageHome::tinted>;

}  // namespace alhazen::render
