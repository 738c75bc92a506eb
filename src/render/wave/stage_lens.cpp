// render/wave: the stages that start a batch through a lens, or inside of solids.
#include "render/wave/camera_samples.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

template <class Real>
void start_lens_rays(Wave<Real>& wave) {
  using L = Wide<Real>;
  push_camera_rays(wave, [&](const FilmPoint<L>& film, const Entries<L>& slots) {
    const auto lens = samples_of<L>(wave, slots, kLensDimension);
    return wave.world.camera.template ray<L>(film, unit_real<L>(lens.x), unit_real<L>(lens.y));
  });
}

// Solids that hold a ray's origin count as entered in the order of the scene: of those of equal
// priority the one written last is there.
template <class Real>
void find_camera_media(Wave<Real>& wave) {
  for (std::size_t i = 0; i < wave.rays.size(); ++i) {
    for (const ShapeId solid : wave.world.solids) {
      if (!wave.world.shapes.contains(solid, wave.rays.origin[i])) continue;
      wave.rays.medium[i] = wave.media.enter(wave.rays.medium[i], wave.world.material_of[solid]);
    }
  }
}

template struct StagesOf<StageHome::lens>;

}  // namespace alhazen::render
