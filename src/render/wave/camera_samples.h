// render/wave: the stages that start a batch: camera rays, and the solids that they start in.
#pragma once

#include "core/math/random.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// What the random numbers of a pixel are for. Light `l` has the dimension kFirstLightDimension + l,
// of the branch of the ray tree that meets it.
inline constexpr std::uint64_t kFilterDimension = 16, kLensDimension = 17;
inline constexpr std::uint64_t kFirstLightDimension = 32;

inline std::uint64_t pixel_seed(std::uint64_t seed, std::int32_t x, std::int32_t y) {
  return mix_64(mix_64(seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
}
// Of the pixel that a slot's sample is of.
template <class Real>
std::uint64_t path_of(const Wave<Real>& wave, std::size_t slot) {
  return pixel_seed(wave.world.seed, static_cast<std::int32_t>(wave.slots.x[slot]),
                    static_cast<std::int32_t>(wave.slots.y[slot]));
}

// Puts each sample where the reconstruction filter wants it. Without this stage it stays in the
// centre of its pixel.
template <class Real>
void place_by_filter(Wave<Real>& wave) {
  Slots<Real>& slots = wave.slots;
  for (std::size_t s = 0; s < slots.size(); ++s) {
    const std::uint64_t path = path_of(wave, s);
    const Sample2d bits = sample_2d(mix_64(path, kFilterDimension), slots.sample[s]);
    const FilterSample place =
        wave.world.filter.sample(unit_real<double>(bits.x), unit_real<double>(bits.y));
    slots.offset_x[s] = static_cast<Real>(place.x);
    slots.offset_y[s] = static_cast<Real>(place.y);
    slots.negative[s] = place.negative ? 1 : 0;
  }
}

// Queues the rays that `make_ray` gives for the film points of several slots at once: ray s is that
// of slot s.
template <class Real, class MakeRay>
void push_camera_rays(Wave<Real>& wave, const MakeRay& make_ray) {
  using L = Wide<Real>;
  Slots<Real>& slots = wave.slots;
  for_lanes<L>(slots.size(), [&](const Entries<L>& at) {
    const FilmPoint<L> film{at.of(slots.x), at.of(slots.y), at.of(slots.offset_x),
                            at.of(slots.offset_y)};
    const CameraRay<L> ray = make_ray(film, at);
    auto& rays = wave.rays;
    const std::size_t first = rays.size();
    rays.grow(first + static_cast<std::size_t>(count(at.active())));
    at.store(ray.origin, rays.origin);
    at.store(ray.direction, rays.direction);
    at.store(Rgb<L>(L(1)), rays.weight);
    rays.source.store(first, at.active(), IntOf<L>(-1), IntOf<L>(kNoFace),
                      IntOf<L>(static_cast<int>(Side::kByDirection)), Vec3<L>());
    at.index().store(rays.slot.data() + first);
    IntOf<L>(kVacuum).store(rays.medium.data() + first);
    IntOf<L>(0).store(rays.depth.data() + first);
    std::fill_n(rays.passed.data() + first, rays.size() - first, 0);
  });
  if (wave.names_paths()) {
    for (std::size_t s = 0; s < slots.size(); ++s)
      wave.rays.path[s] = path_of(wave, s);
  }
  std::fill(slots.rays.begin(), slots.rays.end(), 1);
}

template <class Real>
void start_camera_rays(Wave<Real>& wave) {
  using L = Wide<Real>;
  push_camera_rays(wave, [&](const FilmPoint<L>& film, const Entries<L>&) {
    return wave.world.camera.template ray<L>(film, L(0), L(0));
  });
}

template <class Real>
void start_lens_rays(Wave<Real>& wave) {
  using L = Wide<Real>;
  const Slots<Real>& slots = wave.slots;
  push_camera_rays(wave, [&](const FilmPoint<L>& film, const Entries<L>& at) {
    Real u[L::kWidth] = {}, v[L::kWidth] = {};
    for_each_lane(at.active(), [&](int k) {
      const std::size_t s = at[k];
      const std::uint64_t path = path_of(wave, s);
      const Sample2d lens = sample_2d(mix_64(path, kLensDimension), slots.sample[s]);
      u[k] = unit_real<Real>(lens.x);
      v[k] = unit_real<Real>(lens.y);
    });
    return wave.world.camera.template ray<L>(film, L::load(u), L::load(v));
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

}  // namespace alhazen::render
