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
  b.scene.shapes[0].material = b.material(m);
  EXPECT_EQ(names_of(plan_of(b.scene)),
            (std::vector<std::string>{"pinhole_rays", "closest_hits", "surfaces", "plain_colors",
                                      "pov_glow", "point_on_pov", "opaque_shadows"}));
  m.ambient = Rgbd();
  m.diffuse = 0;
  m.filter = 0.5;
  m.reflection.max = Rgbd(1);
  b.scene.shapes[0].material = b.material(m);
  EXPECT_EQ(names_of(plan_of(b.scene)),
            (std::vector<std::string>{"pinhole_rays", "interfaces", "surfaces", "plain_colors",
                                      "pov_reflection", "pov_transmission"}));
}

TEST(Plan, CoatOverBlackOnlyReflects) {
  SceneBuilder b = plain_scene();
  b.scene.shapes[0].material = b.material(Coat{1.5, Rgbd(0), b.color(Rgbd(0))});
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

// A use of an effect that cannot reach a pixel, and one that can.
struct Use {
  const char* effect;
  void (*dead)(SceneBuilder&);
  void (*live)(SceneBuilder&);
};

const Use kUses[] = {
    {"mirror", [](SceneBuilder& b) { b.mirror(0.9); },
     [](SceneBuilder& b) {
       b.add(Sphere{{1, 0, 0}, 1}, b.mirror(0.9));
     }},
    {"mirror that reflects nothing", [](SceneBuilder& b) { b.mirror(0); },
     [](SceneBuilder& b) {
       b.add(Sphere{{1, 0, 0}, 1}, b.mirror(0.1));
     }},
    {"glass", [](SceneBuilder& b) { b.glass(1.5); },
     [](SceneBuilder& b) {
       b.add(Sphere{{1, 0, 0}, 1}, b.glass(1.5));
     }},
    {"light",
     [](SceneBuilder& b) {
       b.light(SphereLight{{0, 9, 0}, 1, Rgbd(0), 4});
     },
     [](SceneBuilder& b) {
       b.light(SphereLight{{0, 9, 0}, 1, Rgbd(5), 4});
     }},
    {"highlight",
     [](SceneBuilder& b) {
       std::get<Diffuse>(b.scene.materials[0].scattering).highlight.exponent = 99;
     },
     [](SceneBuilder& b) {
       std::get<Diffuse>(b.scene.materials[0].scattering).highlight.strength = Rgbd(0.3);
     }},
    {"texture",
     [](SceneBuilder& b) {
       const TextureId same = b.color(Rgbd(0.5)), too = b.color(Rgbd(0.5));
       b.scene.textures.push_back({CheckerPattern{same, too}, Mapping::object, Affined(), {}});
       std::get<Diffuse>(b.scene.materials[0].scattering).albedo =
           static_cast<TextureId>(b.scene.textures.size() - 1);
     },
     [](SceneBuilder& b) {
       const TextureId one = b.color(Rgbd(0.5)), other = b.color(Rgbd(0.1));
       b.scene.textures.push_back({CheckerPattern{one, other}, Mapping::object, Affined(), {}});
       std::get<Diffuse>(b.scene.materials[0].scattering).albedo =
           static_cast<TextureId>(b.scene.textures.size() - 1);
     }},
    {"lens",
     [](SceneBuilder& b) {
       std::get<PerspectiveCamera>(b.scene.camera.projection).lens = ThinLens{0, 3};
     },
     [](SceneBuilder& b) {
       std::get<PerspectiveCamera>(b.scene.camera.projection).lens = ThinLens{0.5, 3};
     }},
    {"background",
     [](SceneBuilder& b) {
       b.scene.background.source = GradientBackground{{{0, Rgbd(0)}}};
     },
     [](SceneBuilder& b) { b.background(0.5); }},
    {"POV-Ray's reflection and transparency",
     [](SceneBuilder& b) {
       PovFinish m;
       m.color = b.color(Rgbd(0));
       m.filter = 0.5;
       m.ambient = Rgbd(0.5);
       m.reflection.falloff = 2;
       b.add(Sphere{{0.1, 0, 0}, 0.5}, b.material(m));  // black, and out of sight
     },
     [](SceneBuilder& b) {
       PovFinish m;
       m.color = b.color(Rgbd(0.5));
       m.filter = 0.5;
       m.reflection.max = Rgbd(0.5);
       b.add(Sphere{{1, 0, 0}, 1}, b.material(m));
     }},
    {"emission", [](SceneBuilder& b) { b.scene.materials[0].emission = Rgbd(0); },
     [](SceneBuilder& b) { b.scene.materials[0].emission = Rgbd(1); }},
};

TEST(Plan, DeadUsesChangeNothingAndLiveOnesDo) {
  const SceneBuilder plain = plain_scene();
  const RenderOutput base = render_or_fail(plain.scene);
  for (const Use& use : kUses) {
    SceneBuilder dead = plain, live = plain;
    use.dead(dead);
    use.live(live);
    EXPECT_TRUE(plan_of(dead.scene) == plan_of(plain.scene)) << use.effect;
    const RenderOutput with_dead = render_or_fail(dead.scene);
    EXPECT_EQ(with_dead.picture.rgb, base.picture.rgb) << use.effect;
    EXPECT_EQ(with_dead.statistics.rays(), base.statistics.rays()) << use.effect;
    EXPECT_NE(pixels_of(live.scene), base.picture.rgb) << use.effect;
  }
}

}  // namespace
}  // namespace alhazen::render
