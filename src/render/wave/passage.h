// render/wave: what a surface of a dielectric solid means to a ray, given the solids it is inside
// of.
#pragma once

#include "render/surface/absorption.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// What a ray crosses at a surface of a dielectric solid.
template <class Real>
struct Passage {
  MediumId behind;    // the solids it is in beyond the surface
  bool is_interface;  // false where a solid of higher priority, or the same material, fills both
                      // sides
  Real ior_here, ior_behind;
};

// `entering`: the ray goes against the outward normal.
template <class Real>
Passage<Real> cross_surface(const World<Real>& world, MediumPool& media, MediumId here,
                            MaterialId material, bool entering) {
  const auto& priority = world.materials.priorities();
  const MediumId behind = entering ? media.enter(here, material) : media.leave(here, material);
  const MaterialId from = media.current(here, priority), to = media.current(behind, priority);
  return {behind, from != to, world.ior_of(from), world.ior_of(to)};
}

// The same at a shape, which may be a sheet with nothing inside.
template <class Real>
Passage<Real> cross_shape(const World<Real>& world, MediumPool& media, MediumId here, ShapeId shape,
                          bool entering) {
  if (!world.thin[shape]) {
    return cross_surface(world, media, here, world.material_of[shape], entering);
  }
  const Real ior = world.ior_of(media.current(here, world.materials.priorities()));
  return {here, false, ior, ior};
}

// The list of media that a ray is in before it meets a surface. Who leaves a solid it was not known
// to be in has been in it all along: the camera stands in an open shape.
inline MediumId before_surface(MediumPool& media, MediumId here, MaterialId material,
                               bool entering) {
  return entering || media.contains(here, material) ? here : media.enter(here, material);
}

// Whether lanes of rays are where nothing is nested: they come from empty space into the solid, or
// out of it again. There the list of media is the solid's material or none, and crossing its
// surface is from one to the other; nothing has to be looked up.
template <class L>
MaskOf<L> is_plain_passage(const IntOf<L>& here, const IntOf<L>& material, MaskOf<L> enters,
                           MaskOf<L> active) {
  return active && ((enters && here == IntOf<L>(kVacuum)) || (!enters && here == material));
}

// What lanes of rays cross.
template <class L>
struct PassageLanes {
  IntOf<L> here, behind;  // lists of media: before the surface, and beyond it
  MaskOf<L> is_interface;
  L ior_here, ior_behind;
};

// At shapes of dielectric materials, by rays that were last known to be in `medium`.
template <class L>
PassageLanes<L> cross_shapes(Wave<ScalarOf<L>>& wave, const IntOf<L>& medium, const IntOf<L>& shape,
                             const IntOf<L>& material, MaskOf<L> enters, MaskOf<L> active) {
  using Real = ScalarOf<L>;
  const World<Real>& world = wave.world;
  MaskOf<L> plain = is_plain_passage<L>(medium, material, enters, active);
  if (world.thin.any()) {
    for_each_lane(plain, [&](int k) {
      if (world.thin[static_cast<ShapeId>(shape[k])]) {
        plain = plain && !MaskOf<L>::from_bits(std::uint32_t{1} << k);
      }
    });
  }
  const L ior = world.materials.template numbers_of<L>(&MaterialRecord<Real>::ior, material, plain);
  PassageLanes<L> result{medium, select(enters, material, IntOf<L>(kVacuum)), plain,
                         select(enters, L(1), ior), select(enters, ior, L(1))};
  std::uint32_t interfaces = plain.bits();
  for_each_lane(active && !plain, [&](int k) {
    const auto id = static_cast<ShapeId>(shape[k]);
    auto here = static_cast<MediumId>(medium[k]);
    if (!world.thin[id]) {
      here = before_surface(wave.media, here, static_cast<MaterialId>(material[k]), enters[k]);
    }
    const Passage<Real> one = cross_shape(world, wave.media, here, id, enters[k]);
    result.here.set(k, here);
    result.behind.set(k, one.behind);
    result.ior_here.set(k, one.ior_here);
    result.ior_behind.set(k, one.ior_behind);
    if (one.is_interface) interfaces |= std::uint32_t{1} << k;
  });
  result.is_interface = MaskOf<L>::from_bits(interfaces);
  return result;
}

// The share of light that is left after `distance` in what fills the lists of media (Beer and
// Lambert's law); 1 where that is empty space, and in lanes that are not active.
template <class L>
Rgb<L> share_left(const Wave<ScalarOf<L>>& wave, const IntOf<L>& medium, const L& distance,
                  MaskOf<L> active) {
  const MaskOf<L> filled = active && medium != IntOf<L>(kVacuum);
  if (!any(filled)) return Rgb<L>(L(1));
  IntOf<L> inside = medium;
  for_each_lane(filled, [&](int k) {
    const auto list = static_cast<MediumId>(medium[k]);
    if (wave.media.is_single(list)) return;
    inside.set(k, wave.media.current(list, wave.world.materials.priorities()));
  });
  const Rgb<L> absorption = wave.world.materials.template records_of<L>(
      &MaterialRecord<ScalarOf<L>>::absorption, inside, filled);
  return select(filled, transmitted_share(absorption, distance), Rgb<L>(L(1)));
}

}  // namespace alhazen::render
