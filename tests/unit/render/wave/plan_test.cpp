// The plan holds what the scene calls for and nothing else.
#include "render/wave/plan.h"

#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::SceneBuilder;

SceneBuilder plain_scene() {
  SceneBuilder b;
  b.add(Sphere{{0, 0, 0}, 1}, b.diffuse(0.5));
  b.light(PointLight{{3, 3, -3}, Rgbd(20), Falloff::inverse_square});
  b.look({0, 0, -4}, {0, 0, 1}, {0, 1, 0}, 40);
  return b;
}

StagePlan plan_of(const Scene& scene) {
  return make_plan(scene, effects_of(scene));
}

std::vector<std::string> names_of(const StagePlan& plan) {
  std::vector<std::string> names;
  plan.for_each([&](const PlannedStage& stage) { names.emplace_back(info(stage.id).name); });
  return names;
}

TEST(Plan, PlainSceneRunsTheFewStagesItNeeds) {
  EXPECT_EQ(names_of(plan_of(plain_scene().scene)),
            (std::vector<std::string>{"pinhole_rays", "closest_hits", "surfaces", "plain_colors",
                                      "point_on_matte", "opaque_shadows"}));
}

TEST(Plan, WhatSendsRaysOnKeepsThem) {
  for (std::size_t k = 0; k < kStageCount; ++k) {
    const auto stage = static_cast<StageId>(k);
    EXPECT_EQ(sends_rays_on(stage), info(stage).keeps.starts_with("next rays")) << info(stage).name;
  }
}

TEST(Plan, EmptySceneOnlyMakesRays) {
  SceneBuilder b;
  EXPECT_EQ(names_of(plan_of(b.scene)), std::vector<std::string>{"pinhole_rays"});
}

TEST(Plan, SurfacesThatNothingLightsAreNotShaded) {
  SceneBuilder b;
  b.add(Sphere{{0, 0, 0}, 1}, b.diffuse(0.5));
  EXPECT_EQ(names_of(plan_of(b.scene)), (std::vector<std::string>{"pinhole_rays", "closest_hits"}));
  EXPECT_TRUE(make_plan(b.scene, effects_of(b.scene, {.albedo = true}), {.albedo = true})
                  .runs(StageId::plain_colors));
}

TEST(Plan, PovFinishCallsForWhatItDoes) {
  SceneBuilder b = plain_scene();
  PovFinish m;
  m.color = b.color(Rgbd(0.5));
  const MaterialId worn = b.material(m);
  b.change(0, [&](Shape& shape) { shape.material = worn; });
  EXPECT_EQ(names_of(plan_of(b.scene)),
            (std::vector<std::string>{"pinhole_rays", "closest_hits", "surfaces", "plain_colors",
                                      "pov_glow", "point_on_pov", "opaque_shadows"}));
  m.ambient = Rgbd();
  m.diffuse = 0;
  m.filter = 0.5;
  m.reflection.max = Rgbd(1);
  const MaterialId clear = b.material(m);
  b.change(0, [&](Shape& shape) { shape.material = clear; });
  EXPECT_EQ(names_of(plan_of(b.scene)),
            (std::vector<std::string>{"pinhole_rays", "interfaces", "surfaces", "plain_colors",
                                      "pov_reflection", "pov_transmission"}));
}

TEST(Plan, CoatOverBlackOnlyReflects) {
  SceneBuilder b = plain_scene();
  const MaterialId worn = b.material(Coat{1.5, Rgbd(0), b.color(Rgbd(0))});
  b.change(0, [&](Shape& shape) { shape.material = worn; });
  EXPECT_EQ(names_of(plan_of(b.scene)),
            (std::vector<std::string>{"pinhole_rays", "closest_hits", "surfaces", "coat"}));
}

TEST(Plan, BackgroundBehindATransparentPictureIsSeenInMirrorsOnly) {
  SceneBuilder b = plain_scene();
  b.background(1);
  b.scene.settings.transparent_background = true;
  EXPECT_FALSE(plan_of(b.scene).runs(StageId::escape));
  b.add(Sphere{{2, 0, 0}, 1}, b.mirror(0.5));
  EXPECT_TRUE(plan_of(b.scene).runs(StageId::escape));
}

// Uses that are dead because of what else is in the scene; those that are dead by themselves stand
// in scenes/effects.
void expect_dead(const SceneBuilder& with, const SceneBuilder& without) {
  EXPECT_TRUE(plan_of(with.scene) == plan_of(without.scene));
  const RenderOutput a = render_or_fail(with.scene), b = render_or_fail(without.scene);
  EXPECT_EQ(a.picture.rgb, b.picture.rgb);
  EXPECT_EQ(a.statistics.rays(), b.statistics.rays());
}

TEST(Plan, HighlightsUnderAnEvenSkyAreNone) {
  SceneBuilder without, with;
  for (SceneBuilder* b : {&without, &with}) {
    b->add(Sphere{{0, 0, 0}, 1}, b->diffuse(0.5));
    b->light(AmbientLight{Rgbd(1)});
    b->look({0, 0, -4}, {0, 0, 1}, {0, 1, 0}, 40);
  }
  std::get<Diffuse>(with.scene.materials[0].scattering).highlight.strength = Rgbd(0.3);
  expect_dead(with, without);
}

TEST(Plan, EvenSkyOnBlackSurfacesIsNone) {
  SceneBuilder without = plain_scene();
  auto& worn = std::get<Diffuse>(without.scene.materials[0].scattering);
  worn.albedo = without.color(Rgbd(0));
  worn.highlight.strength = Rgbd(0.3);
  SceneBuilder with = without;
  with.light(AmbientLight{Rgbd(1)});
  expect_dead(with, without);
}

TEST(Plan, PatternsThatNothingLightsAreNone) {
  SceneBuilder without;
  without.add(Sphere{{0, 0, 0}, 1}, without.diffuse(0.5));
  without.add(Sphere{{1, 0, 0}, 1}, without.mirror(0.9));  // its colour is asked for
  without.background(1);
  without.look({0, 0, -4}, {0, 0, 1}, {0, 1, 0}, 40);
  SceneBuilder with = without;
  const TextureId one = with.color(Rgbd(0.5)), other = with.color(Rgbd(0.1));
  with.scene.textures.push_back({CheckerPattern{one, other}, Mapping::object, Affined(), {}});
  std::get<Diffuse>(with.scene.materials[0].scattering).albedo =
      static_cast<TextureId>(with.scene.textures.size() - 1);
  expect_dead(with, without);
  const PlanWants albedo{.albedo = true};
  const EffectSet effects = effects_of(with.scene, albedo);
  EXPECT_TRUE(make_plan(with.scene, effects, albedo).runs(StageId::textured_colors));
}

TEST(Plan, LightsThatDoNotShineMoveNoRandomNumbers) {
  SceneBuilder without = plain_scene(), with = without;
  with.light(PointLight{{0, 3, 0}, Rgbd(0), Falloff::inverse_square});
  for (SceneBuilder* b : {&without, &with})
    b->light(SphereLight{{-3, 3, -3}, 1, Rgbd(5), 4});
  expect_dead(with, without);
}

TEST(Plan, SolidsAreLookedForWhereRaysMayStart) {
  const auto runs = [](Vec3d glass_at, std::optional<ThinLens> lens) {
    SceneBuilder b = plain_scene();
    b.add(Sphere{glass_at, 1}, b.glass(1.5));
    std::get<PerspectiveCamera>(b.scene.camera.projection).lens = lens;
    return plan_of(b.scene).runs(StageId::camera_media);
  };
  EXPECT_FALSE(runs({0, 0, 0}, std::nullopt));
  EXPECT_TRUE(runs({0, 0, -4.5}, std::nullopt));
  EXPECT_FALSE(runs({0, 0, 0}, ThinLens{0.1, 3})) << "the lens is in the air";
  EXPECT_TRUE(runs({1.1, 0, -4}, ThinLens{0.3, 3})) << "the lens reaches into the ball";
  EXPECT_FALSE(runs({1.1, 0, -4}, ThinLens{0, 3}));
  SceneBuilder b = plain_scene();
  b.add(Sphere{{2, 0, -4}, 1}, b.glass(1.5));
  b.scene.camera.projection = OrthographicCamera{4};
  EXPECT_TRUE(plan_of(b.scene).runs(StageId::camera_media));
  b.scene.camera.projection = OrthographicCamera{0.2};
  EXPECT_FALSE(plan_of(b.scene).runs(StageId::camera_media));
}

}  // namespace
}  // namespace alhazen::render
