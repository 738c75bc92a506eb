// Pictures made until they are as good as was asked for.
#include <cmath>

#include "support/busy_scene.h"
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::busy_scene;
using testing::SceneBuilder;

Scene asked_for(Scene scene, double error, double share = 0) {
  scene.settings.max_error = ErrorTarget{error, share};
  return scene;
}

double rmse(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// Two mirrors that face each other, one with a hole for the camera between them; they reflect
// `reflectance` and glow by 0.1, so that depth d has the light 0.1 (1 + r + .. + r^d).
Scene hall_of_mirrors(double reflectance) {
  SceneBuilder b;
  const MaterialId glowing = b.material(Mirror{b.color(Rgbd(reflectance))}, Rgbd(0.1));
  b.add(Plane{{0, 0, -1}, -1}, glowing);
  b.add(Plane{{0, 0, 1}, -1}, glowing);
  b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 10);
  b.scene.settings.width = b.scene.settings.height = 8;
  return b.scene;
}

TEST(Target, NeitherThreadsNorTilesChangeABit) {
  const Scene scene = asked_for(busy_scene(), 1.0 / 48);
  const RenderOutput one = render_or_fail(scene, {.threads = 1});
  for (const RenderOptions& options :
       {RenderOptions{.threads = 3}, RenderOptions{.threads = 2, .limits = {.tile_size = 7}},
        RenderOptions{.limits = {.tile_size = 64, .generation_rays = 5}}}) {
    const RenderOutput other = render_or_fail(scene, options);
    EXPECT_EQ(other.picture.rgb, one.picture.rgb);
    EXPECT_EQ(other.picture.error, one.picture.error);
    EXPECT_EQ(other.accuracy->bound, one.accuracy->bound);
    EXPECT_EQ(other.accuracy->passes, one.accuracy->passes);
  }
}

TEST(Target, IsReachedAndTheBoundHolds) {
  Scene reference = busy_scene();
  // Of 256 samples: a fraction of the smallest error that is asked for below.
  reference.settings.samples = 256;
  reference.settings.max_depth = 32;
  reference.settings.cutoff = 1e-4;
  reference.settings.seed = 5;
  const std::vector<double> converged = pixels_of(reference);
  for (const double error : {1.0 / 16, 1.0 / 48}) {
    const RenderOutput output = render_or_fail(asked_for(busy_scene(), error));
    ASSERT_TRUE(output.accuracy);
    EXPECT_EQ(output.accuracy->end, AccuracyEnd::reached);
    EXPECT_LE(output.accuracy->estimate, output.accuracy->bound);
    EXPECT_LE(output.accuracy->bound, error);
    EXPECT_LE(rmse(output.picture.rgb, converged), error);
    EXPECT_EQ(output.picture.error.size(), output.picture.alpha.size());
  }
}

TEST(Target, SmoothScenesEndAtOnce) {
  SceneBuilder b;
  b.background(0.25);
  b.scene.settings.width = 64;
  b.scene.settings.height = 40;
  const RenderOutput output = render_or_fail(asked_for(b.scene, 1.0 / 1024));
  EXPECT_EQ(output.accuracy->estimate, 0);
  EXPECT_EQ(output.accuracy->truncation, 0);
  EXPECT_EQ(output.picture.rgb, std::vector<double>(3 * 64 * 40, 0.25));
  // No ray is sent on, so no depth is tried out.
  // Each pixel once, and one in eight twice, by lot: 7 of 2560 pixels' standard deviations more.
  EXPECT_LE(static_cast<double>(output.statistics.rays()), 1.2 * 64 * 40);
}

// 0.1 / (1 - r) is what never ends; the depth is such that r^d of it is small.
TEST(Target, RaysAreFollowedAsDeepAsTheLightIs) {
  const double error = 1.0 / 255;
  for (const double reflectance : {0.3, 0.9, 0.98}) {
    const RenderOutput output = render_or_fail(asked_for(hall_of_mirrors(reflectance), error));
    EXPECT_EQ(output.accuracy->end, AccuracyEnd::reached) << reflectance;
    const double whole = 0.1 / (1 - reflectance);
    const std::vector<double> expected(output.picture.rgb.size(), whole);
    const double missing = rmse(output.picture.rgb, expected);
    EXPECT_LE(missing, error / 4) << reflectance;
    EXPECT_LE(missing, output.accuracy->truncation * (1 + 1e-9)) << reflectance;
  }
}

TEST(Target, LightWithoutEndIsTold) {
  const RenderOutput output = render_or_fail(asked_for(hall_of_mirrors(1), 1.0 / 255));
  EXPECT_EQ(output.accuracy->end, AccuracyEnd::out_of_depth);
}

TEST(Target, TheTimeLimitLeavesAWholePicture) {
  const Scene scene = asked_for(busy_scene(), 1e-5);
  const RenderOutput output =
      render_or_fail(scene, {.aovs = {.samples = true}, .time_limit = 1e-9});
  EXPECT_EQ(output.accuracy->end, AccuracyEnd::out_of_time);
  EXPECT_GT(output.accuracy->bound, 1e-5);
  const auto [fewest, most] =
      std::minmax_element(output.picture.samples.begin(), output.picture.samples.end());
  EXPECT_EQ(*fewest, 1);
  EXPECT_EQ(*most, 2);
}

TEST(Target, NothingIsToldWithoutOne) {
  const RenderOutput output = render_or_fail(busy_scene());
  EXPECT_FALSE(output.accuracy);
  EXPECT_TRUE(output.picture.error.empty());
}

}  // namespace
}  // namespace alhazen::render
