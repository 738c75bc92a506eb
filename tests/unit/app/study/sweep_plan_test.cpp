#include "app/study/sweep_plan.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <set>

#include "render/wave/plan.h"
#include "support/scene_builder.h"

namespace alhazen {
namespace {

using alhazen::testing::SceneBuilder;
using ::testing::Contains;
using ::testing::Field;

SceneBuilder matte_scene() {
  SceneBuilder builder;
  builder.add(Sphere{{0, 0, 5}, 1}, builder.diffuse(0.5));
  builder.light(PointLight{{0, 5, 0}, {1, 1, 1}});
  builder.scene.settings.samples = 16;
  return builder;
}

SweepPlan plan_of(const SceneBuilder& builder) {
  return plan_sweep(builder.scene, render::effects_of(builder.scene));
}

std::set<Knob> knobs_of(const SweepPlan& plan) {
  std::set<Knob> knobs;
  for (const StudySetting& setting : plan.settings)
    knobs.insert(setting.knob);
  return knobs;
}

TEST(SweepPlan, MatteSceneHasNoDepthAndNoLightSamplesAndSaysWhy) {
  const SweepPlan plan = plan_of(matte_scene());
  EXPECT_EQ(knobs_of(plan),
            (std::set{Knob::samples, Knob::adaptive, Knob::target, Knob::filter, Knob::precision}));
  for (const char* what : {"light samples", "depth", "cutoff"}) {
    EXPECT_THAT(plan.left_out, Contains(Field(&LeftOut::what, what)));
  }
  for (const LeftOut& left : plan.left_out)
    EXPECT_FALSE(left.why.empty());
}

TEST(SweepPlan, EachEffectCallsForItsKnobs) {
  SceneBuilder mirror = matte_scene();
  mirror.add(Sphere{{2, 0, 5}, 1}, mirror.mirror(0.9));
  EXPECT_THAT(knobs_of(plan_of(mirror)), Contains(Knob::depth));
  EXPECT_THAT(knobs_of(plan_of(mirror)), Contains(Knob::cutoff));
  EXPECT_THAT(knobs_of(plan_of(mirror)), Contains(Knob::combination));
  SceneBuilder lamp = matte_scene();
  lamp.light(SphereLight{{3, 3, 0}, 1, {1, 1, 1}});
  EXPECT_THAT(knobs_of(plan_of(lamp)), Contains(Knob::light_samples));
}

TEST(SweepPlan, MirrorThatNothingWearsCallsForNothing) {
  SceneBuilder builder = matte_scene();
  builder.mirror(0.9);
  EXPECT_THAT(knobs_of(plan_of(builder)), ::testing::Not(Contains(Knob::depth)));
}

TEST(SweepPlan, OneKnobIsTurnedAtATime) {
  SceneBuilder builder = matte_scene();
  builder.add(Sphere{{2, 0, 5}, 1}, builder.mirror(0.9));
  const RenderSettings& own = builder.scene.settings;
  for (const StudySetting& s : plan_of(builder).settings) {
    SCOPED_TRACE(describe(s));
    if (s.knob == Knob::combination) continue;
    EXPECT_TRUE(s.knob == Knob::depth || s.settings.max_depth == own.max_depth);
    EXPECT_TRUE(s.knob == Knob::cutoff || s.settings.cutoff == own.cutoff);
    EXPECT_TRUE(s.knob == Knob::filter || s.settings.filter.kind == own.filter.kind);
    EXPECT_TRUE(s.knob == Knob::adaptive || !s.settings.adaptive);
    EXPECT_TRUE(s.knob == Knob::precision || s.precision == render::Precision::float64);
  }
}

TEST(SweepPlan, ScenesOwnSettingsStandInItOnce) {
  for (const int samples : {16, 17}) {
    SceneBuilder builder = matte_scene();
    builder.scene.settings.samples = samples;
    const SweepPlan plan = plan_of(builder);
    const auto own = [](const StudySetting& s) { return s.is_scene; };
    ASSERT_EQ(std::ranges::count_if(plan.settings, own), 1);
    const StudySetting& found = *std::ranges::find_if(plan.settings, own);
    EXPECT_EQ(found.settings.samples, samples);
    EXPECT_EQ(found.knob, Knob::samples);
  }
}

TEST(SweepPlan, AdaptiveSceneIsItsOwnPoint) {
  SceneBuilder builder = matte_scene();
  builder.scene.settings.adaptive = AdaptiveSampling{0.037, 8};
  builder.scene.settings.samples = 500;
  const SweepPlan plan = plan_of(builder);
  const auto own = [](const StudySetting& s) { return s.is_scene; };
  const StudySetting& found = *std::ranges::find_if(plan.settings, own);
  EXPECT_EQ(found.knob, Knob::adaptive);
  EXPECT_EQ(found.label, "t 0.037");
}

TEST(SweepPlan, SceneWithAnErrorTargetIsItsOwnPoint) {
  SceneBuilder builder = matte_scene();
  builder.scene.settings.max_error = ErrorTarget{1.0 / 100, 0};
  const SweepPlan plan = plan_of(builder);
  for (const StudySetting& s : plan.settings)
    EXPECT_EQ(s.settings.max_error.has_value(), s.knob == Knob::target) << describe(s);
  const auto own = [](const StudySetting& s) { return s.is_scene; };
  const StudySetting& found = *std::ranges::find_if(plan.settings, own);
  EXPECT_EQ(found.label, "1/100");
  EXPECT_EQ(describe(found), "max-error 1/100, box");
}

TEST(SweepPlan, NoCurveHasAPointTwice) {
  const SweepPlan plan = plan_of(matte_scene());
  for (const StudySetting& a : plan.settings) {
    const auto twin = [&](const StudySetting& b) { return a.knob == b.knob && is_same(a, b); };
    EXPECT_EQ(std::ranges::count_if(plan.settings, twin), 1) << describe(a);
  }
}

TEST(StudySetting, SceneGetsItsLightSamplesAndSettings) {
  SceneBuilder builder = matte_scene();
  builder.light(SphereLight{{3, 3, 0}, 1, {1, 1, 1}, 4});
  StudySetting setting;
  setting.settings = builder.scene.settings;
  setting.settings.max_depth = 3;
  setting.light_samples = 9;
  const Scene scene = scene_with(builder.scene, setting);
  EXPECT_EQ(scene.settings.max_depth, 3);
  EXPECT_EQ(std::get<SphereLight>(scene.lights[1].source).samples, 9);
}

TEST(StudySetting, IsDescribedWithAllThatCouldBeChosenOtherwise) {
  StudySetting setting;
  setting.settings.samples = 1;
  EXPECT_EQ(describe(setting), "1 sample, depth 16, cutoff 1/512, box");
  setting.settings.adaptive = AdaptiveSampling{0.02, 4};
  setting.settings.samples = 1024;
  setting.settings.cutoff = 0;
  setting.light_samples = 1;
  setting.precision = render::Precision::float32;
  EXPECT_EQ(describe(setting),
            "adaptive 0.02, 4 to 1024 samples, 1 light sample, depth 16, cutoff 0, box, float");
}

}  // namespace
}  // namespace alhazen
