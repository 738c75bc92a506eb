// One picture, the same bits: any number of threads, any crop, any scale 2^k, any place.
#include "support/busy_scene.h"
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::busy_scene;
using testing::SceneBuilder;

TEST(Invariance, ThreadsDoNotChangeABit) {
  const Scene scene = busy_scene();
  const std::vector<double> one = pixels_of(scene, {.threads = 1});
  EXPECT_EQ(pixels_of(scene, {.threads = 2}), one);
  EXPECT_EQ(pixels_of(scene, {.threads = 16}), one);
}

// Tiles of every size, and generations cut into parts of every size, down to single samples.
TEST(Invariance, TheCutOfTheWorkDoesNotChangeABit) {
  const Scene scene = busy_scene();
  const std::vector<double> usual = pixels_of(scene, {.threads = 1});
  for (const int tile : {1, 7, 16, 64}) {
    EXPECT_EQ(pixels_of(scene, {.threads = 2, .limits = {.tile_size = tile}}), usual) << tile;
  }
  for (const std::size_t rays : {std::size_t{1}, std::size_t{5}, std::size_t{100000}}) {
    EXPECT_EQ(pixels_of(scene, {.limits = {.tile_size = 64, .generation_rays = rays}}), usual)
        << rays;
  }
}

TEST(Invariance, CropsPutTogetherAreTheWholePicture) {
  const Scene scene = busy_scene();
  const Picture whole = render_or_fail(scene).picture;
  // Cuts that fall on no tile of the whole picture.
  const int xs[] = {0, 7, 31, 50}, ys[] = {0, 13, 38};
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 3; ++i) {
      const PixelRect crop{xs[i], ys[j], xs[i + 1] - xs[i], ys[j + 1] - ys[j]};
      const Picture part = render_or_fail(scene, {.crop = crop}).picture;
      for (int y = crop.y; y < crop.y + crop.height; ++y) {
        for (int x = crop.x; x < crop.x + crop.width; ++x) {
          ASSERT_EQ(pixel_at(part, x, y), pixel_at(whole, x, y)) << x << "," << y;
        }
      }
    }
  }
}

// F1: all lengths times 2^k, absorption times 2^-k.
TEST(Invariance, PowersOfTwoInScaleDoNotChangeABit) {
  const std::vector<double> plain = pixels_of(busy_scene());
  for (const double scale : {0x1p-300, 0x1p-10, 0x1p1, 0x1p100, 0x1p300}) {
    EXPECT_EQ(pixels_of(busy_scene(scale)), plain) << scale;
  }
}

// F3: everything moved by a vector that is added without rounding: coordinates in 64ths of a
// length.
TEST(Invariance, RepresentableTranslationsDoNotChangeABit) {
  const auto in_64ths = [](Vec3d move) {
    SceneBuilder b;
    const auto at = [move](int x, int y, int z) { return Vec3d(x, y, z) / 64.0 + move; };
    b.background(0.3);
    b.add(Sphere{at(-70, 5, 60), 1}, b.glass(1.5));
    b.add(Sphere{at(77, 0, 100), 1}, b.mirror(0.9));
    b.add(Box{at(-600, -80, -600), at(600, -64, 600)}, b.diffuse(0.7));
    b.light(PointLight{at(250, 400, -260), Rgbd(90), Falloff::inverse_square});
    b.scene.settings.width = b.scene.settings.height = 40;
    b.look(at(3, 70, -450), {0, 0, 1}, {0, 1, 0}, 55);
    return pixels_of(b.scene);
  };
  const std::vector<double> base = in_64ths({});
  for (const double t : {0x1p10, 0x1p30, 0x1p44}) {
    EXPECT_EQ(in_64ths({t, -t, 2 * t}), base) << t;
  }
}

TEST(Invariance, AdaptiveSamplingIsAsDeterministic) {
  Scene scene = busy_scene();
  scene.settings.samples = 64;
  scene.settings.adaptive = AdaptiveSampling{0.02, 8};
  const RenderOutput one = render_or_fail(scene, {.threads = 1, .aovs = {.samples = true}});
  const RenderOutput two = render_or_fail(scene, {.threads = 2, .aovs = {.samples = true}});
  EXPECT_EQ(one.picture.rgb, two.picture.rgb);
  EXPECT_EQ(one.picture.samples, two.picture.samples);
  EXPECT_GT(one.statistics.samples, 8u * 50 * 38);   // somewhere more was wanted
  EXPECT_LT(one.statistics.samples, 64u * 50 * 38);  // and not everywhere
}

// The oracle follows the same samples: differences are rounding, but for paths decided by a hair.
TEST(Precision, DoubleAgreesWithQuad) {
  Scene scene = busy_scene();
  scene.settings.width = 24;
  scene.settings.height = 18;
  scene.settings.samples = 1;
  const std::vector<double> in_double = pixels_of(scene);
  const std::vector<double> in_quad = pixels_of(scene, {.precision = Precision::quad});
  double worst = 0;
  for (std::size_t i = 0; i < in_double.size(); ++i) {
    worst = std::max(worst, std::abs(in_double[i] - in_quad[i]));
  }
  std::printf("double against quad: worst %.3g\n", worst);
  EXPECT_LE(worst, 1e-9);
}

// A scene that sends thousands of light paths from every point: the same picture, in small batches.
TEST(Invariance, ManyLightSamplesAreFollowedInParts) {
  Scene scene = busy_scene();
  scene.settings.width = scene.settings.height = 8;
  scene.settings.samples = 2;
  std::get<SphereLight>(scene.lights[1].source).samples = 1024;
  const std::vector<double> one = pixels_of(scene, {.threads = 1});
  EXPECT_EQ(pixels_of(scene, {.threads = 3}), one);
  EXPECT_EQ(pixels_of(scene, {.crop = {3, 2, 1, 1}})[0], one[3 * (2 * 8 + 3)]);
}

// D4: a tree of reflections and refractions that doubles with every generation. A light of 1024
// samples makes generations of 256 rays the largest that are followed at once, so this one sample
// is cut often.
TEST(Invariance, OneSamplesTreeMayBeLargerThanAGenerationMayBe) {
  SceneBuilder b;
  b.add(Sphere{{0, 0, 0}, 9}, b.material(Mirror{b.color(Rgbd(1))}, Rgbd(0.001)));
  for (int i = 0; i < 4; ++i)
    b.add(Sphere{{0.1 * i, 0.2 * i, 2.0 * i - 3}, 0.9}, b.glass(1.5));
  b.scene.settings.max_depth = 26;
  b.scene.settings.cutoff = 1e-7;
  b.scene.settings.width = b.scene.settings.height = 2;
  b.look({0.3, 0.2, -6}, {0, 0, 1}, {0, 1, 0}, 40);
  const RenderOutput whole = render_or_fail(b.scene);
  EXPECT_GT(whole.statistics.rays(), std::uint64_t{10000});
  b.light(SphereLight{{1, 5, 0}, 1, Rgbd(1), 1024});
  const RenderOutput cut = render_or_fail(b.scene, {.threads = 1});
  EXPECT_EQ(cut.statistics.rays(), whole.statistics.rays());
  EXPECT_EQ(pixels_of(b.scene, {.crop = {1, 1, 1, 1}})[0], pixel_at(cut.picture, 1, 1).r);
  for (std::size_t i = 0; i < whole.picture.rgb.size(); ++i) {
    EXPECT_NEAR(cut.picture.rgb[i], whole.picture.rgb[i], 1e-15);  // another order of the same sum
  }
}

// Colour and coverage are reconstructed alike, so an evenly glowing thing keeps colour = alpha.
TEST(Render, TransparentBackgroundGivesMatchingAlpha) {
  SceneBuilder b;
  b.add(Sphere{{0, 0, 0}, 1}, b.material(Black{}, Rgbd(1)));
  b.scene.settings.transparent_background = true;
  b.background(5);
  b.scene.settings.samples = 16;
  b.scene.settings.filter = {FilterKind::mitchell, 2};
  b.look({0, 0, -4}, {0, 0, 1}, {0, 1, 0}, 45);
  const Picture picture = render_or_fail(b.scene).picture;
  for (std::size_t p = 0; p < picture.alpha.size(); ++p) {
    EXPECT_FLOAT_EQ(picture.alpha[p], static_cast<float>(picture.rgb[3 * p]));
  }
  EXPECT_EQ(picture.alpha[0], 0);
}

TEST(Render, RectangleLightsAreSeenFromTheSideTheyShineTo) {
  SceneBuilder b;
  b.add(Quad4{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, b.material(Black{}, Rgbd(3)));  // faces +z
  b.scene.materials[0].one_sided_emission = true;
  EXPECT_EQ(central_radiance(b, {0, 0, -5}), 0);
  b.look({0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 1e-3);
  EXPECT_EQ(pixels_of(b.scene)[0], 3);
}

TEST(Render, CropOutsideOfTheFrameIsAUsageError) {
  const Scene scene = busy_scene();
  for (const PixelRect crop : {PixelRect{-1, 0, 5, 5}, PixelRect{48, 0, 5, 5},
                               PixelRect{0, 0, 5, 0}, PixelRect{0, 38, 1, 1}}) {
    const auto output = alhazen::render::render(scene, {}, {.crop = crop});
    ASSERT_FALSE(output);
    EXPECT_EQ(output.error().code, ErrorCode::usage);
  }
}

TEST(Render, CancelledRunSaysSo) {
  const std::atomic<bool> cancel = true;
  const auto output = alhazen::render::render(busy_scene(), {}, {.cancel = &cancel});
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::stopped);
}

}  // namespace
}  // namespace alhazen::render
