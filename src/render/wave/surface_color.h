// render/wave: the colour of surfaces, which is one of its material's numbers or a texture.
#pragma once

#include "render/wave/world.h"

namespace alhazen::render {

// Of several lanes, those whose material's colour is a texture.
template <class L>
MaskOf<L> are_textured(const World<ScalarOf<L>>& world, const IntOf<L>& material,
                       MaskOf<L> active) {
  return active && world.materials.template patterns_of<L>(material, active) != IntOf<L>(0);
}

// The colours of several lanes, albedo or reflectance. texture_points(mask) gives the coordinates
// that textures ask for, and is called only if one does. `with_images`: some may be images.
template <class L, bool with_images, class TexturePoints>
Rgb<L> surface_colors(const World<ScalarOf<L>>& world, const IntOf<L>& material, MaskOf<L> active,
                      const TexturePoints& texture_points) {
  using Int = IntOf<L>;
  const Rgb<L> solid = world.materials.template records_of<L>(
      &MaterialRecord<ScalarOf<L>>::solid_color, material, active);
  const Int pattern = world.materials.template patterns_of<L>(material, active);
  const MaskOf<L> asks = active && pattern != Int(0);
  if (!any(asks)) return solid;
  const Int texture = pattern + Int(-1);
  const TexturePoint<L> points = texture_points(asks);
  return select(asks, world.textures.template color<L, with_images>(texture, points, asks), solid);
}

}  // namespace alhazen::render
