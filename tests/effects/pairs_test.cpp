// For every effect there is, a scene in scenes/effects with its name: `use` 0 is the scene without
// it, 1 a use that is seen, 2 and more are uses that cannot reach a pixel. What is dead changes
// neither the plan nor a bit of the picture nor a count of rays; what lives changes plan and
// picture. The tests are made from the table of effects: one without its scene fails.
#include <algorithm>
#include <gtest/gtest.h>

#include "parser/eval/evaluate.h"
#include "render/image/exr_write.h"
#include "render/wave/render.h"

namespace alhazen {
namespace {

// What one `use` of a scene comes to.
struct Use {
  EffectSet effects;
  render::StagePlan plan;
  render::RenderStatistics figures;
  std::string exr;  // colours, alpha and depth as the bytes of a file
};

struct LoadedUse {
  Scene scene;
  int last_use = 0;  // as the range of the scene's parameter `use` says
};

std::string scene_path(Effect effect) {
  return std::string(ALHAZEN_SOURCE_DIR) + "/scenes/effects/" + std::string(info(effect).name) +
         ".scn";
}

// Nothing, with a failure, if there is no such scene or it has no such use.
std::optional<LoadedUse> load(Effect effect, int use) {
  SourceManager sources;
  DiagnosticSink sink;
  parser::EvalOptions options;
  options.defines = {{"use", std::to_string(use)}};
  const parser::Evaluation read = parser::evaluate_file(scene_path(effect), sources, sink, options);
  if (!read.scene || read.params.size() != 1 || read.params[0].name != "use") {
    ADD_FAILURE() << scene_path(effect) << " is no scene with a `param use`";
    return std::nullopt;
  }
  const std::string& range = read.params[0].range;
  return LoadedUse{*read.scene, std::stoi(range.substr(range.rfind(' ') + 1))};
}

// Any pictures do for the files that a scene names.
std::vector<render::ImagePixels> pictures_for(const Scene& scene) {
  return std::vector<render::ImagePixels>(scene.images.size(),
                                          {2, 2, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.25F, 0.5F, 0.75F}});
}

std::string exr_of(const render::Picture& picture) {
  render::ExrFile file;
  file.display_window = {0, 0, picture.window.width, picture.window.height};
  file.data_window = file.display_window;
  file.beauty = {picture.window.width, picture.window.height, {"R", "G", "B", "A"}};
  file.beauty_type = render::SampleType::float32;
  file.data = {picture.window.width, picture.window.height, {"Z"}};
  for (std::size_t p = 0; p < picture.alpha.size(); ++p) {
    for (std::size_t c = 0; c < 3; ++c)
      file.beauty.channel(c)[p] = static_cast<float>(picture.rgb[3 * p + c]);
    file.beauty.channel(3)[p] = picture.alpha[p];
    file.data.channel(0)[p] = std::min(picture.depth[p], render::kBackgroundDepth);
  }
  const auto encoded = render::encode_exr(file);
  EXPECT_TRUE(encoded) << (encoded ? "" : encoded.error().message);
  return encoded ? encoded.value().bytes : "";
}

Use made(const Scene& scene) {
  render::RenderOptions options;
  options.threads = 1;
  options.aovs.depth = true;
  const auto output = render::render(scene, pictures_for(scene), options);
  EXPECT_TRUE(output) << (output ? "" : output.error().message);
  if (!output) return {};
  return {render::effects_of(scene), output.value().plan, output.value().statistics,
          exr_of(output.value().picture)};
}

void expect_same(const Use& dead, const Use& plain, const std::string& what) {
  EXPECT_TRUE(dead.plan == plain.plan) << what;
  EXPECT_TRUE(dead.exr == plain.exr) << what << " changes the picture";
  const render::RenderStatistics &a = dead.figures, &b = plain.figures;
  EXPECT_EQ(a.camera_rays, b.camera_rays) << what;
  EXPECT_EQ(a.reflection_rays, b.reflection_rays) << what;
  EXPECT_EQ(a.refraction_rays, b.refraction_rays) << what;
  EXPECT_EQ(a.shadow_rays, b.shadow_rays) << what;
  EXPECT_EQ(a.samples, b.samples) << what;
  ASSERT_EQ(a.stages.size(), b.stages.size()) << what;
  for (std::size_t i = 0; i < a.stages.size(); ++i) {
    EXPECT_EQ(a.stages[i].rays, b.stages[i].rays) << what;
  }
}

// Dead uses that a scene's text cannot say: `--samples 4` for a scene that is adaptive from 4 on.
std::vector<Scene> unwritten_uses(Effect effect, Scene scene) {
  if (effect != Effect::adaptive_sampling) return {};
  scene.settings.adaptive = AdaptiveSampling{0.001, scene.settings.samples};
  return {scene};
}

class EveryEffect : public testing::TestWithParam<Effect> {};

TEST_P(EveryEffect, IsThereWhereItIsSeenAndNowhereElse) {
  const Effect effect = GetParam();
  const auto plain_scene = load(effect, 0), live_scene = load(effect, 1);
  ASSERT_TRUE(plain_scene && live_scene);
  const Use plain = made(plain_scene->scene), live = made(live_scene->scene);
  EXPECT_FALSE(plain.effects.has(effect));
  EXPECT_TRUE(live.effects.has(effect));
  EXPECT_FALSE(live.plan == plain.plan);
  EXPECT_FALSE(live.exr == plain.exr) << "the use that should be seen changes no pixel";
  bool works = false;  // in some stage
  live.plan.for_each([&](const render::PlannedStage& stage) {
    for (const auto* list : {&stage.because, &stage.serves})
      works = works || std::find(list->begin(), list->end(), effect) != list->end();
  });
  EXPECT_TRUE(works) << "no stage says that it is for it";

  int dead_uses = 0;
  for (int use = 2; use <= plain_scene->last_use; ++use, ++dead_uses) {
    const auto dead = load(effect, use);
    ASSERT_TRUE(dead);
    expect_same(made(dead->scene), plain, "use " + std::to_string(use));
  }
  for (const Scene& scene : unwritten_uses(effect, plain_scene->scene)) {
    expect_same(made(scene), plain, "a use that only the command line can make");
    ++dead_uses;
  }
  EXPECT_GT(dead_uses, 0) << "no use of it is dead";
}

std::vector<Effect> all_effects() {
  std::vector<Effect> effects;
  for (std::size_t i = 0; i < kEffectCount; ++i)
    effects.push_back(static_cast<Effect>(i));
  return effects;
}

INSTANTIATE_TEST_SUITE_P(Effects, EveryEffect, testing::ValuesIn(all_effects()),
                         [](const auto& each) {
                           return std::string(alhazen::info(each.param).name);
                         });

}  // namespace
}  // namespace alhazen
