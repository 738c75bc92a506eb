// render/wave: what names the samples of a pixel, and how their rays are queued.
#pragma once

#include "core/math/random.h"
#include "render/wave/wave.h"

namespace alhazen::render {

// What the random numbers of a pixel are for. Light `l` has the dimension kFirstLightDimension + l,
// of the branch of the ray tree that meets it.
inline constexpr std::uint64_t kFilterDimension = 16, kLensDimension = 17;
inline constexpr std::uint64_t kFirstLightDimension = 32;

// The seed of everything that is random in a pixel; `Word` is std::uint64_t or lanes of it.
template <class Word>
Word pixel_seed(Word seed, Word x, Word y) {
  constexpr std::uint64_t kLow = 0xffffffff;  // coordinates are of 32 bits
  return mix_64(mix_64(seed, x & kLow), y & kLow);
}
// Of the pixels that the samples of several slots are of.
template <class L>
Lanes<std::uint64_t, L::kWidth> paths_of(const Wave<ScalarOf<L>>& wave, const Entries<L>& slots) {
  using Words = Lanes<std::uint64_t, L::kWidth>;
  return pixel_seed(Words(wave.world.seed), Words(slots.of(wave.slots.x)),
                    Words(slots.of(wave.slots.y)));
}

// Of each slot's sample the point that is for `dimension`.
template <class L>
Sample2dOf<Lanes<std::uint32_t, L::kWidth>> samples_of(const Wave<ScalarOf<L>>& wave,
                                                       const Entries<L>& slots,
                                                       std::uint64_t dimension) {
  using Words = Lanes<std::uint64_t, L::kWidth>;
  return sample_2d(mix_64(paths_of<L>(wave, slots), Words(dimension)), slots.of(wave.slots.sample));
}

// Queues the rays that `make_ray` gives for the film points of several slots at once: ray s is that
// of slot s.
template <class Real, class MakeRay>
void push_camera_rays(Wave<Real>& wave, const MakeRay& make_ray) {
  using L = Wide<Real>;
  Slots<Real>& slots = wave.slots;
  const bool names_paths = wave.names_paths();
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
    if (names_paths) paths_of<L>(wave, at).store(rays.path.data() + first);
  });
  std::fill(slots.rays.begin(), slots.rays.end(), 1);
}

}  // namespace alhazen::render
