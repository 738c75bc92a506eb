// render/wave: the stages of hits on textured surfaces.
#include "render/wave/find_surfaces.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real>
void find_textured_colors(Wave<Real>& wave) {
  using L = Wide<Real>;
  auto& hits = wave.hits;
  for_lanes<L>(hits.size(), [&](const Entries<L>& at) {
    const auto texture_points = [&](MaskOf<L>) {
      return TexturePoint<L>{at.of(hits.object_position), at.of(hits.position), at.of(hits.u),
                             at.of(hits.v)};
    };
    at.store(surface_colors<L, is_built_here(Effect::image_textures)>(
                 wave.world, at.of(hits.material), at.active(), texture_points),
             hits.color);
  });
}

template struct StagesOf<StageHome::textures>;

}  // namespace alhazen::render
