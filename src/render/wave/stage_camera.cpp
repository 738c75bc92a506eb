// render/wave: the stages that start a batch through a pinhole, or with parallel rays.
#include "render/wave/camera_samples.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// Puts each sample where the reconstruction filter wants it. Without this stage it stays in the
// centre of its pixel.
template <class Real>
void place_by_filter(Wave<Real>& wave) {
  using L = Wide<Real>;
  Slots<Real>& slots = wave.slots;
  for_lanes<L>(slots.size(), [&](const Entries<L>& at) {
    const auto bits = samples_of<L>(wave, at, kFilterDimension);
    const Numbers x(bits.x), y(bits.y);
    for_each_lane(at.active(), [&](int k) {
      const std::size_t s = at[k];
      const FilterSample place =
          wave.world.filter.sample(unit_real<double>(x[k]), unit_real<double>(y[k]));
      slots.offset_x[s] = static_cast<Real>(place.x);
      slots.offset_y[s] = static_cast<Real>(place.y);
      slots.negative[s] = place.negative ? 1 : 0;
    });
  });
}

template <class Real>
void start_camera_rays(Wave<Real>& wave) {
  using L = Wide<Real>;
  push_camera_rays(wave, [&](const FilmPoint<L>& film, const Entries<L>&) {
    return wave.world.camera.template ray<L>(film, L(0), L(0));
  });
}

template struct StagesOf<StageHome::camera>;

}  // namespace alhazen::render
