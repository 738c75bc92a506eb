// render/wave: the stages of rays that meet nothing, of what is lost on the way, and of what glows.
#include "render/wave/passage.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// Beer and Lambert's law over the segment just travelled, in the medium that it lay in.
template <class Real>
void absorb(Wave<Real>& wave) {
  using L = Wide<Real>;
  const auto lose = [&](const Entries<L>& rays, const L& distance) {
    const IntOf<L> medium = rays.of(wave.rays.medium);
    if (!any(rays.active() && medium != IntOf<L>(kVacuum))) return;
    rays.put(rays.of(wave.rays.weight) * share_left(wave, medium, distance, rays.active()),
             wave.rays.weight);
  };
  for_lanes<L>(wave.hits.size(), [&](const Entries<L>& at) {
    lose(Entries<L>(at.of(wave.hits.ray), at.active()), at.of(wave.hits.hit.t));
  });
  for_lanes<L>(wave.escaped, [&](const Entries<L>& rays) { lose(rays, L(infinity<L>())); });
}

// Sums into samples stay in the order of the queue: lanes may belong to one sample.
template <class Real, class Radiance>
void add_where_nothing_is(Wave<Real>& wave, const Radiance& radiance) {
  using L = Wide<Real>;
  for_lanes<L>(wave.escaped, [&](const Entries<L>& rays) {
    MaskOf<L> seen = rays.active();
    if (wave.world.transparent_background) {
      seen = seen && rays.of(wave.rays.source.shape) != IntOf<L>(-1);
    }
    wave.add(rays, seen, radiance(rays.of(wave.rays.direction)));
  });
}

template <class Real>
void add_background(Wave<Real>& wave) {
  const auto& background = wave.world.background;
  add_where_nothing_is(
      wave, [&](const Vec3<Wide<Real>>& d) { return background.template plain<Wide<Real>>(d); });
}

template <class Real>
void add_environment(Wave<Real>& wave) {
  const auto& background = wave.world.background;
  add_where_nothing_is(
      wave, [&](const Vec3<Wide<Real>>& d) { return background.template picture<Wide<Real>>(d); });
}

template <class Real>
void add_emission(Wave<Real>& wave) {
  for (const std::size_t h : wave.glowing) {
    wave.add(wave.hits.ray_of(h), wave.world.materials[wave.hits.material_of(h)].emission);
  }
}

template struct StagesOf<StageHome::escape>;

}  // namespace alhazen::render
