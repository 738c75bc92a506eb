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

// The surfaces of dielectric solids where nothing is nested: from empty space into the solid, or
// out of it again. There the list of media is the solid's material or none, and crossing is from
// one to the other; nothing has to be looked up, so lanes go together.
template <class L>
struct PlainPassage {
  MaskOf<L> is;     // the others mean nothing
  IntOf<L> behind;  // a MediumId
  L ior_here, ior_behind;

  PlainPassage(const World<ScalarOf<L>>& world, const IntOf<L>& here, const IntOf<L>& material,
               MaskOf<L> enters, MaskOf<L> active)
      : is(is_plain(here, material, enters, active)),
        behind(select(enters, material, IntOf<L>(kVacuum))) {
    const L ior =
        world.materials.template numbers_of<L>(&MaterialRecord<ScalarOf<L>>::ior, material, is);
    ior_here = select(enters, L(1), ior);
    ior_behind = select(enters, ior, L(1));
  }

  static MaskOf<L> is_plain(const IntOf<L>& here, const IntOf<L>& material, MaskOf<L> enters,
                            MaskOf<L> active) {
    return active && ((enters && here == IntOf<L>(kVacuum)) || (!enters && here == material));
  }
};

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

// The list of media that a ray is in before it meets a surface. Who leaves a solid it was not known
// to be in has been in it all along: the camera stands in an open shape.
inline MediumId before_surface(MediumPool& media, MediumId here, MaterialId material,
                               bool entering) {
  return entering || media.contains(here, material) ? here : media.enter(here, material);
}

}  // namespace alhazen::render
