// Builds that leave effects out: which those are, what goes with them, and what a scene is told
// that calls for one.
#include "core/scene/left_out.h"

#include <gtest/gtest.h>

#include "render/wave/plan.h"

namespace alhazen {
namespace {

static_assert(is_name_of_effect("mirror") && !is_name_of_effect("mirrors"));
static_assert(lists_effects_only("") && lists_effects_only("mirror,textures"));
static_assert(!lists_effects_only("mirror;textures") && !lists_effects_only("mirror,glass"));
static_assert(is_left_out(Effect::mirror, "metal,mirror") && !is_left_out(Effect::mirror, "metal"));
static_assert(!is_left_out(Effect::coat_base, "mirror") && is_left_out(Effect::coat_base, "coat"));
static_assert(is_left_out(Effect::soft_shadows, "direct_light"), "by way of shadows");

TEST(LeftOut, ASceneThatCallsForItIsRefusedByName) {
  EffectSet effects;
  effects.call(Effect::matte, {});
  EXPECT_TRUE(render::check_built_in(effects, ""));
  EXPECT_TRUE(render::check_built_in(effects, "mirror"));
  const Status refused = render::check_built_in(effects, "mirror,matte");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_NE(refused.error().message.find("matte surfaces"), std::string::npos);
}

// No stage of an effect is in a build without it, and every other stage is in it.
TEST(LeftOut, ItsStagesGoWithIt) {
  const auto built = [](render::StageId stage, std::string_view left_out) {
    return render::is_called(stage, [&](Effect e) { return !is_left_out(e, left_out); });
  };
  using enum render::StageId;
  EXPECT_FALSE(built(mirror, "mirror"));
  EXPECT_TRUE(built(metal, "mirror"));
  EXPECT_TRUE(built(interfaces, "refraction")) << "pov_transmission needs it, too";
  EXPECT_FALSE(built(interfaces, "refraction,pov_transmission"));
  EXPECT_FALSE(built(sphere_on_coat, "coat"));
  EXPECT_FALSE(built(opaque_shadows, "direct_light"));
  for (std::size_t i = 0; i < render::kStageCount; ++i) {
    EXPECT_TRUE(built(static_cast<render::StageId>(i), "")) << render::kStageInfo[i].name;
  }
}

}  // namespace
}  // namespace alhazen
