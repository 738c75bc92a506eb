// Signatures and margins of whole pictures.
#include <cmath>
#include <set>

#include "support/busy_scene.h"
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::busy_scene;
using testing::SceneBuilder;

constexpr AovRequest kBoth{.signature = true, .margin = true};

Picture decisions_of(const Scene& scene, RenderOptions options = {}) {
  options.aovs = kBoth;
  return render_or_fail(scene, options).picture;
}

TEST(Signature, IsThereOnlyWhenAskedFor) {
  const Scene scene = busy_scene();
  const RenderOutput plain = render_or_fail(scene);
  EXPECT_TRUE(plain.picture.signature.empty());
  EXPECT_TRUE(plain.picture.margin.empty());
  for (const StageId id :
       {StageId::sign_hits, StageId::sign_lights, StageId::weigh_hits, StageId::weigh_lights}) {
    EXPECT_FALSE(plain.plan.runs(id)) << info(id).name;
  }
  const RenderOutput asked = render_or_fail(scene, {.aovs = kBoth});
  EXPECT_TRUE(asked.plan.runs(StageId::sign_lights));
  EXPECT_EQ(asked.picture.rgb, plain.picture.rgb);
  EXPECT_EQ(asked.statistics.rays(), plain.statistics.rays());
}

TEST(Signature, DoesNotDependOnThreadsOrCrops) {
  const Scene scene = busy_scene();
  const Picture one = decisions_of(scene, {.threads = 1});
  const Picture many = decisions_of(scene, {.threads = 5});
  EXPECT_EQ(one.signature, many.signature);
  EXPECT_EQ(one.margin, many.margin);
  const PixelRect crop{7, 13, 30, 20};
  const Picture part = decisions_of(scene, {.crop = crop});
  for (int y = 0; y < crop.height; ++y) {
    for (int x = 0; x < crop.width; ++x) {
      const auto here = static_cast<std::size_t>(y * crop.width + x);
      const auto there = static_cast<std::size_t>((crop.y + y) * 50 + crop.x + x);
      ASSERT_EQ(part.signature[here], one.signature[there]);
      ASSERT_EQ(part.margin[here], one.margin[there]);
    }
  }
}

// One pixel: what its signature tells apart, and what it does not.
std::uint64_t signature_of(const SceneBuilder& b) {
  return decisions_of(b.scene).signature.front();
}
SceneBuilder one_pixel() {
  SceneBuilder b;
  b.scene.settings.width = b.scene.settings.height = 1;
  b.look({0, 0, -5}, {0, 0, 1}, {0, 1, 0}, 1e-3);
  b.add(Sphere{{0, 0, 0}, 1}, b.diffuse(0.5));
  b.light(PointLight{{3, 3, -9}, Rgbd(20), Falloff::inverse_square});
  return b;
}

TEST(Signature, TellsDecisionsApartAndNothingElse) {
  const std::uint64_t base = signature_of(one_pixel());
  SceneBuilder larger = one_pixel();
  larger.change(0, [](Shape& s) { std::get<Sphere>(s.geometry).radius = 1.25; });
  EXPECT_EQ(signature_of(larger), base);
  SceneBuilder other_shape = one_pixel();
  other_shape.change(0, [](Shape& s) { s.geometry = Box{{-1, -1, -1}, {1, 1, 1}}; });
  SceneBuilder empty = one_pixel();
  empty.change(0, [](Shape& s) { std::get<Sphere>(s.geometry).center.x = 3; });
  SceneBuilder shadowed = one_pixel();
  shadowed.add(Sphere{{1.5, 1.5, -5}, 0.5}, shadowed.diffuse(0.5));
  SceneBuilder behind = one_pixel();
  std::get<PointLight>(behind.scene.lights[0].source).position.z = 9;
  SceneBuilder mirrored = one_pixel();
  const MaterialId mirror = mirrored.mirror(0.5);
  mirrored.change(0, [&](Shape& s) { s.material = mirror; });
  const std::set<std::uint64_t> all = {base,
                                       signature_of(other_shape),
                                       signature_of(empty),
                                       signature_of(shadowed),
                                       signature_of(behind),
                                       signature_of(mirrored)};
  EXPECT_EQ(all.size(), 6u);
}

double margin_of(const SceneBuilder& b) {
  return decisions_of(b.scene).margin.front();
}

// Two quads that face the camera, at depths 4 and 4 (1 + e): the order has the margin e / (2 + e).
TEST(Margin, IsTheGapOfTheTwoNearestHits) {
  for (const int k : {2, 8, 16, 20}) {
    const double e = std::ldexp(1, -k);
    SceneBuilder b;
    b.scene.settings.width = b.scene.settings.height = 1;
    b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e-3);
    for (const double depth : {4.0, 4 * (1 + e)})
      b.add(Quad4{{-3, -3, depth}, {6, 0, 0}, {0, 6, 0}}, b.diffuse(0.5));
    EXPECT_FLOAT_EQ(static_cast<float>(margin_of(b)), static_cast<float>(e / (2 + e)));
  }
}

// A ball beyond what is met decides nothing, however nearly it is grazed; in front of it, it does.
TEST(Margin, LooksAtWhatCouldBeMetOnly) {
  for (const bool in_front : {true, false}) {
    SceneBuilder b;
    b.scene.settings.width = b.scene.settings.height = 1;
    b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e-3);
    b.add(Quad4{{-3, -3, 4}, {6, 0, 0}, {0, 6, 0}}, b.diffuse(0.5));
    b.add(Sphere{{1 + 0x1p-30, 0, in_front ? 2.0 : 8.0}, 1}, b.diffuse(0.5));
    if (in_front) {
      EXPECT_LT(margin_of(b), 1e-9);
    } else {
      EXPECT_GT(margin_of(b), 0.1);
    }
  }
}

// Light that grazes the floor at a slope 2^-k, and total reflection missed by 2^-k.
TEST(Margin, IsTheCosineOfAGrazingLight) {
  for (const int k : {4, 12, 20}) {
    const double e = std::ldexp(1, -k);
    SceneBuilder b;
    b.scene.settings.width = b.scene.settings.height = 1;
    b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e-3);
    b.add(Plane{{0, 0, -1}, -4}, b.diffuse(0.5));
    b.light(DirectionalLight{normalized(Vec3d(1, 0, e)), Rgbd(1)});
    EXPECT_NEAR(margin_of(b) / e, 1, 0.01);
  }
}

}  // namespace
}  // namespace alhazen::render
