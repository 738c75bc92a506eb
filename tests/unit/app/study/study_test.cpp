#include "app/study/study.h"

#include <algorithm>
#include <gmock/gmock.h>

#include "app/study/conclusions.h"
#include "app/study/povray_sweep.h"
#include "render/color/color_config.h"
#include "support/scene_builder.h"

namespace alhazen {
namespace {

using alhazen::testing::SceneBuilder;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;

SceneBuilder ball_and_mirror() {
  SceneBuilder builder;
  builder.scene.settings.width = builder.scene.settings.height = 8;
  builder.scene.settings.samples = 4;
  builder.scene.settings.cutoff = 1.0 / 512;
  builder.background(0.5);
  builder.add(Sphere{{0, 0, 4}, 1}, builder.mirror(0.8));
  builder.add(Sphere{{1.5, 0, 4}, 0.7}, builder.diffuse(0.7));
  builder.light(PointLight{{0, 5, 0}, {30, 30, 30}});
  return builder;
}

Result<SceneStudy> study_of(const Scene& scene, const StudyOptions& options) {
  static const render::ColorConfig colors = render::ColorConfig::builtin().value();
  static const SourceManager sources;
  static const std::vector<render::ImagePixels> images;
  return study_scene({"test", scene, images, sources, {}, colors.display_transform().value(), 8, 8},
                     options);
}

TEST(StudyScene, GoesFromASceneToFiguresOfEveryKind) {
  const SceneBuilder builder = ball_and_mirror();
  StudyOptions options;
  options.seconds = 0.5;
  options.runs = 2;
  const auto study = study_of(builder.scene, options);
  ASSERT_TRUE(study) << study.error().message;
  const SceneStudy& s = study.value();
  EXPECT_EQ(s.scene_point().setting.settings.samples, 4);
  EXPECT_GT(s.reference.samples, 4 * 4);
  EXPECT_GE(s.reference.max_depth, 64);
  EXPECT_GT(s.sampling_error, 0);
  EXPECT_LT(s.sampling_error, s.scene_point().errors.rmse);
  for (const StudyPoint& point : s.points) {
    EXPECT_GT(point.cpu.median, 0);
    EXPECT_GE(point.runs, 1);
    EXPECT_GT(point.statistics.camera_rays, 0u);
    EXPECT_EQ(point.pictures.shown.size(), 3u * 8 * 8);
    const bool truncates = point.setting.knob == Knob::depth || point.setting.knob == Knob::cutoff;
    EXPECT_EQ(point.truncation_rmse.has_value(), truncates);
  }
  EXPECT_THAT(s.left_out, Contains(Field(&LeftOut::what, "light samples")));
  // Errors fall along the front.
  const auto front = front_of(s, false);
  for (std::size_t i = 1; i < front.size(); ++i)
    EXPECT_LT(s.points[front[i]].errors.rmse, s.points[front[i - 1]].errors.rmse);
}

TEST(StudyScene, DeeperPathsLeaveLessOut) {
  const SceneBuilder builder = ball_and_mirror();
  StudyOptions options;
  options.seconds = 0.5;
  options.runs = 1;
  const auto study = study_of(builder.scene, options);
  ASSERT_TRUE(study);
  double last = 1e9;
  for (const StudyPoint& point : study.value().points) {
    if (point.setting.knob != Knob::depth) continue;
    EXPECT_LE(*point.truncation_rmse, last) << point.setting.label;
    last = *point.truncation_rmse;
  }
  EXPECT_LT(last, 1e9);
}

TEST(StudyScene, CanBeStopped) {
  const SceneBuilder builder = ball_and_mirror();
  const std::atomic<bool> cancelled = true;
  StudyOptions options;
  options.cancel = &cancelled;
  const auto study = study_of(builder.scene, options);
  ASSERT_FALSE(study);
  EXPECT_EQ(study.error().code, ErrorCode::stopped);
}

TEST(StudyScene, WithoutPovRayThereAreOurPointsAndTheReason) {
  const SceneBuilder builder = ball_and_mirror();
  StudyOptions options;
  options.seconds = 1;
  options.runs = 1;
  options.with_povray = true;
  options.povray = "/nowhere/povray";
  const auto study = study_of(builder.scene, options);
  ASSERT_TRUE(study) << study.error().message;
  EXPECT_FALSE(study.value().points.empty());
  EXPECT_THAT(study.value().povray->failure, HasSubstr("POV-Ray is needed"));
}

TEST(PovraySettings, HaveBothMethodsThresholdsAndDepths) {
  const auto settings = povray_settings(false);
  const auto has = [&](Knob knob, const char* words) {
    return std::ranges::any_of(settings, [&](const PovraySetting& s) {
      return s.knob == knob && std::ranges::find(s.words, words) != s.words.end();
    });
  };
  for (const Knob knob : {Knob::povray_method_1, Knob::povray_method_2}) {
    EXPECT_TRUE(has(knob, "+A0.3000"));
    EXPECT_TRUE(has(knob, "+A0.0000"));
    EXPECT_TRUE(has(knob, "+R2"));
    EXPECT_TRUE(has(knob, "+R5"));
  }
  for (const PovraySetting& setting : povray_settings(true))
    EXPECT_GT(setting.blur_samples, 0);
}

TEST(PovraySettings, ErrorsOfReferencesFollowTheirLaws) {
  // n^-3/2: off by 8 and by 8 / 2^1.5, so apart by the difference at most.
  EXPECT_NEAR(error_of_finer_grid(8 - 8 / 2.8284271247461903), 8 / 2.8284271247461903, 1e-12);
  // Independent: sqrt(2 e^2 + e^2).
  EXPECT_NEAR(error_of_more_samples(1.7320508075688772), 1, 1e-12);
}

}  // namespace
}  // namespace alhazen
