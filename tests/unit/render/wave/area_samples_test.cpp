// Samples of area lights: dealt to lanes they are those of each hit one by one, in that order.
#include "render/wave/area_samples.h"

#include <gtest/gtest.h>

#include "render/simd/elementary.h"
#include "support/scene_builder.h"
#include "unit/render/wave/push_ray.h"

namespace alhazen::render {
namespace {

constexpr std::size_t kHits = 11;  // the last lanes of any width are not full

Scene lit_scene(int samples) {
  testing::SceneBuilder builder;
  SphereLight sphere;
  sphere.center = {0, 5, 0};
  sphere.radiance = {1, 2, 3};
  sphere.samples = samples;
  RectangleLight rectangle;
  rectangle.corner = {-2, 3, -2};
  rectangle.edge_u = {4, 0, 0};
  rectangle.edge_v = {0, 0, 4};
  rectangle.radiance = {3, 2, 1};
  rectangle.samples = samples;
  builder.light(sphere);
  builder.light(rectangle);
  return builder.scene;
}

// Hit h is of ray kHits - 1 - h; points below, inside and behind the lights are among them.
template <class Real>
void fill(Wave<Real>& wave) {
  wave.slots.resize(kHits, {});
  for (std::size_t i = 0; i < kHits; ++i) {
    wave.slots.sample[i] = static_cast<std::uint32_t>(i);
    push_ray(wave.rays,
             {.weight = Rgb<Real>(Real(1)), .slot = static_cast<SlotId>(i), .path = mix_64(i, 5)});
  }
  wave.hits.make_room(kHits);
  for (std::size_t h = 0; h < kHits; ++h) {
    wave.hits.push(kHits - 1 - h, {Real(1), 0, 0, true});
    const Real x = static_cast<Real>(h);
    wave.hits.position.set(h, {x / 8, x * Real(0.75) - 1, Real(0.25)});
  }
}

template <class L, template <class> class View, class Placed>
void expect_same_samples(const Wave<ScalarOf<L>>& wave, const Placed& light) {
  using Real = ScalarOf<L>;
  const auto samples = static_cast<std::uint32_t>(light.kernel.samples);
  std::size_t place = 0;
  for_lanes<L>(kHits, [&](const Entries<L>& hits) {
    visit_area<View>(wave, light, hits, [&](const Entries<L>& dealt, const LightSample<L>& all) {
      for_each_lane(dealt.active(), [&](int lane) {
        const std::size_t h = place / samples;
        const auto k = static_cast<std::uint32_t>(place++ % samples);
        ASSERT_EQ(dealt[lane], h);
        const auto of_hit = area_sequence_at(wave, light, h);
        const Sample2d bits =
            sample_2d_of(of_hit.keys, static_cast<std::uint32_t>(of_hit.first + k));
        const LightSample<Real> one = View<Real>(light.kernel, wave.hits.position[h])
                                          .sample(unit_real<Real>(bits.x), unit_real<Real>(bits.y));
        EXPECT_EQ(all.direction.x[lane], one.direction.x);
        EXPECT_EQ(all.direction.y[lane], one.direction.y);
        EXPECT_EQ(all.distance[lane], one.distance);
        EXPECT_EQ(all.weight.g[lane], one.weight.g);
      });
    });
  });
  EXPECT_EQ(place, kHits * samples);
}

template <class L>
void expect_dealt_in_order(int samples) {
  const Scene scene = lit_scene(samples);
  const World<ScalarOf<L>> world(scene, {});
  Wave<ScalarOf<L>> wave(world);
  fill(wave);
  expect_same_samples<L, SphereLightView>(wave, world.lights.spheres.at(0));
  expect_same_samples<L, RectangleLightView>(wave, world.lights.rectangles.at(0));
}

TEST(AreaSamples, AreDealtInTheOrderOfHits) {
  for (const int samples : {1, 2, 3, 4, 16, 19}) {  // fewer and more than lanes
    expect_dealt_in_order<Wide<double>>(samples);
    expect_dealt_in_order<Wide<float>>(samples);
    expect_dealt_in_order<Lanes<double, 8>>(samples);
    expect_dealt_in_order<Lanes<double, 16>>(samples);
    expect_dealt_in_order<Lanes<float, 16>>(samples);
#if ALHAZEN_HAS_QUAD
    expect_dealt_in_order<Wide<Quad>>(samples);
#endif
  }
}

}  // namespace
}  // namespace alhazen::render
