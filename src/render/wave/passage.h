// render/wave: what a surface of a dielectric solid means to a ray, given the solids it is inside
// of.
#pragma once

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

}  // namespace alhazen::render
