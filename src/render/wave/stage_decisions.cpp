// render/wave: signatures and margins of what the rays of a generation decided (AovRequest in
// render.h). These stages look at decisions again that others have taken; they run only where one
// of the two channels was asked for, and then nothing else changes.
#include "render/wave/area_samples.h"
#include "render/wave/margin.h"
#include "render/wave/passage.h"
#include "render/wave/stage_home.h"

namespace alhazen::render {

// A ray is named by its path, so sums of words do not depend on the order of the rays.
template <class Real>
void sign(Wave<Real>& wave, SlotId slot, std::uint64_t name, std::uint64_t what) {
  wave.slots.signature[slot] += mix_64(name, what);
}

inline std::uint64_t word_of(ShapeId shape, int face, bool enters) {
  return mix_64(shape, 2 * static_cast<std::uint64_t>(face) + (enters ? 1 : 0));
}
inline constexpr std::uint64_t kMetNothing = ~std::uint64_t{0};

// Snell's cos^2 of the refracted ray over max(1, eta^2), where a ray meets something clear: below 0
// it is reflected totally.
template <class Real>
std::optional<Real> refraction_at(Wave<Real>& wave, std::size_t h) {
  const MaterialId id = wave.hits.material_of(h);
  const MaterialRecord<Real>& material = wave.world.materials[id];
  if (material.kind != SurfaceKind::glass && !material.pov_clear) return std::nullopt;
  const Hit<Real> hit = wave.hits.hit[h];
  MediumId here = wave.rays.medium[wave.hits.ray_of(h)];
  if (!wave.world.thin[hit.shape]) here = before_surface(wave.media, here, id, hit.enters);
  const Passage<Real> passage = cross_shape(wave.world, wave.media, here, hit.shape, hit.enters);
  const Real eta = passage.ior_here / passage.ior_behind;
  const Real cosine = -dot(wave.rays.direction[wave.hits.ray_of(h)], wave.hits.shading_normal[h]);
  const Real kept = larger(Real(0), smaller(Real(1), cosine));
  return cos_transmitted_squared(kept, eta) / larger(Real(1), eta * eta);
}

template <class Real>
void sign_hits(Wave<Real>& wave) {
  for (const std::size_t i : wave.escaped)
    sign(wave, wave.rays.slot[i], wave.rays.path[i], kMetNothing);
  for (std::size_t h = 0; h < wave.hits.size(); ++h) {
    const std::size_t i = wave.hits.ray_of(h);
    const Hit<Real> hit = wave.hits.hit[h];
    const auto refraction = refraction_at(wave, h);
    const bool total = refraction && *refraction < Real(0);
    sign(wave, wave.rays.slot[i], mix_64(wave.rays.path[i], total ? 1 : 0),
         word_of(hit.shape, hit.face, hit.enters));
  }
}

template <class Real>
void weigh_hits(Wave<Real>& wave) {
  for (const std::size_t i : wave.escaped) {
    wave.weigh(wave.rays.slot[i],
               margin_of_hit<Real>(wave.world, wave.rays.ray(i), wave.rays.source[i], nullptr));
  }
  for (std::size_t h = 0; h < wave.hits.size(); ++h) {
    const std::size_t i = wave.hits.ray_of(h);
    const SlotId slot = wave.rays.slot[i];
    const Hit<Real> hit = wave.hits.hit[h];
    wave.weigh(slot, margin_of_hit(wave.world, wave.rays.ray(i), wave.rays.source[i], &hit));
    if (const auto refraction = refraction_at(wave, h)) wave.weigh(slot, absolute(*refraction));
  }
}

// One sample of a light at one hit, as the stages of lights see it (lit_surfaces.h).
template <class Real>
struct LightQuestion {
  std::size_t hit;
  LightSample<Real> sample;
  std::uint64_t name;
  ShapeId lamp;
  bool casts_shadows;
};

// Calls `visit(h, sample, k)` with sample k of an area light at each of the hits.
template <template <class> class View, class Real, class Placed, class Visitor>
void visit_area_one_by_one(const Wave<Real>& wave, const typename Wave<Real>::List& hits,
                           const Placed& light, const Visitor& visit) {
  for (const std::size_t h : hits) {
    const View<Real> view(light.kernel, wave.hits.position[h]);
    const auto of_hit = area_sequence_at(wave, light, h);
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(light.kernel.samples); ++k) {
      const Sample2d bits = sample_2d_of(of_hit.keys, static_cast<std::uint32_t>(of_hit.first + k));
      visit(h, view.sample(unit_real<Real>(bits.x), unit_real<Real>(bits.y)), k);
    }
  }
}

// Calls `visit` with every question that the lights ask of this generation's hits.
template <class Real, class Visitor>
void for_each_light_question(const Wave<Real>& wave, const Visitor& visit) {
  const auto& lights = wave.world.lights;
  const auto ask = [&](std::size_t h, const LightSample<Real>& sample, std::uint32_t k,
                       const auto& light) {
    // Of no length where a light is at the point, or turns its back on it.
    if (!(dot(sample.direction, sample.direction) > Real(0))) return;
    const std::uint64_t branch = wave.rays.path[wave.hits.ray_of(h)];
    const std::uint64_t name = mix_64(mix_64(branch, kFirstLightDimension + light.id), k);
    visit(LightQuestion<Real>{h, sample, name, light.visible_shape, light.casts_shadows});
  };
  for (const auto* hits : {&wave.of(SurfaceKind::matte), &wave.of(SurfaceKind::glossy),
                           &wave.of(SurfaceKind::coat), &wave.of(SurfaceKind::pov)}) {
    const auto of_light = [&](const auto& light) {
      return
          [&](std::size_t h, const LightSample<Real>& s, std::uint32_t k) { ask(h, s, k, light); };
    };
    for (const std::size_t h : *hits) {
      const Vec3<Real> position = wave.hits.position[h];
      for (const auto& light : lights.points)
        ask(h, light.kernel.sample(position), 0, light);
      for (const auto& light : lights.spots)
        ask(h, light.kernel.sample(position), 0, light);
      for (const auto& light : lights.directionals)
        ask(h, light.kernel.sample(), 0, light);
    }
    for (const auto& light : lights.spheres)
      visit_area_one_by_one<SphereLightView>(wave, *hits, light, of_light(light));
    for (const auto& light : lights.rectangles)
      visit_area_one_by_one<RectangleLightView>(wave, *hits, light, of_light(light));
  }
}

// How far the light and the viewer stand on the side of the surface that they are to stand on:
// cosines, the smallest of which is below 0 where the surface does not face one of them.
template <class Real>
Real facing(const Wave<Real>& wave, const LightQuestion<Real>& q) {
  const Vec3<Real> normal = wave.hits.shading_normal[q.hit];
  const Real above = dot(wave.hits.geometric_normal[q.hit], q.sample.direction);
  const Real outside = wave.hits.hit[q.hit].enters ? above : -above;
  const Real view = -dot(normal, wave.rays.direction[wave.hits.ray_of(q.hit)]);
  return smaller(smaller(dot(normal, q.sample.direction), outside), view);
}

// What stands in the light's way, as a word: 1 if something solid does; else the sum of the clear
// surfaces that it passes.
template <class Real>
std::uint64_t obstacles(const Wave<Real>& wave, const LightQuestion<Real>& q, const Ray<Real>& ray,
                        const Source& source) {
  const World<Real>& world = wave.world;
  std::uint64_t sum = 0;
  auto hit = closest_hit(world.tree, ray, source, q.sample.distance, q.lamp);
  while (hit) {
    if (!world.lets_light_pass(hit->shape)) return 1;
    sum += word_of(hit->shape, hit->face, hit->enters);
    hit = next_hit(world.tree, ray, source, *hit, q.sample.distance, q.lamp);
  }
  return sum;
}

template <class Real>
void sign_lights(Wave<Real>& wave) {
  for_each_light_question(wave, [&](const LightQuestion<Real>& q) {
    if (!(facing(wave, q) > Real(0))) return;
    const Ray<Real> ray{wave.hits.position[q.hit], q.sample.direction};
    const std::uint64_t way =
        q.casts_shadows ? obstacles(wave, q, ray, wave.source_at(q.hit, false)) : 0;
    sign(wave, wave.rays.slot[wave.hits.ray_of(q.hit)], q.name, way);
  });
}

template <class Real>
void weigh_lights(Wave<Real>& wave) {
  for_each_light_question(wave, [&](const LightQuestion<Real>& q) {
    const SlotId slot = wave.rays.slot[wave.hits.ray_of(q.hit)];
    const Real cosine = facing(wave, q);
    wave.weigh(slot, absolute(cosine));
    if (!(cosine > Real(0)) || !q.casts_shadows) return;
    const Ray<Real> ray{wave.hits.position[q.hit], q.sample.direction};
    const Source source = wave.source_at(q.hit, false);
    const bool arrives = obstacles(wave, q, ray, source) != 1;
    wave.weigh(slot, margin_of_shadow(wave.world, ray, source, q.sample.distance, q.lamp, arrives));
  });
}

template struct StagesOf<StageHome::decisions>;

}  // namespace alhazen::render
