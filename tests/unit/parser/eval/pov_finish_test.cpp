// The block of POV-Ray's surface model: defaults, both ways to write a reflection, variations.
#include <gtest/gtest.h>

#include "core/scene/effect.h"
#include "support.h"

namespace alhazen::parser {
namespace {

PovFinish finish_of(const std::string& text) {
  Evaluated e;
  evaluate_into(e, kCamera + text);
  EXPECT_TRUE(e.result.scene) << e.diagnostics();
  if (!e.result.scene) return {};
  return std::get<PovFinish>(e.scene().materials.at(e.scene().shapes[0].material).scattering);
}

TEST(PovFinish, DefaultsAreThoseOfTheRecord) {
  const PovFinish got = finish_of("sphere { material pov_finish { } }");
  const PovFinish want{};
  EXPECT_EQ(got.filter, want.filter);
  EXPECT_EQ(got.transmit, want.transmit);
  EXPECT_EQ(got.ambient, want.ambient);
  EXPECT_EQ(got.emission, want.emission);
  EXPECT_EQ(got.diffuse, want.diffuse);
  EXPECT_EQ(got.brilliance, want.brilliance);
  EXPECT_EQ(got.phong, want.phong);
  EXPECT_EQ(got.phong_size, want.phong_size);
  EXPECT_EQ(got.specular, want.specular);
  EXPECT_EQ(got.roughness, want.roughness);
  EXPECT_EQ(got.metallic, want.metallic);
  EXPECT_EQ(got.reflection.min, want.reflection.min);
  EXPECT_EQ(got.reflection.max, want.reflection.max);
  EXPECT_EQ(got.conserve_energy, want.conserve_energy);
  EXPECT_EQ(got.ior, want.ior);
  EXPECT_EQ(got.fade_distance, want.fade_distance);
  EXPECT_EQ(got.fade_power, want.fade_power);
  EXPECT_EQ(got.fade_color, want.fade_color);
}

TEST(PovFinish, EveryPropertyArrives) {
  const PovFinish m = finish_of(R"(
sphere {
  material pov_finish {
    color rgb(1.5, 0.2, 0.1)  filter 0.25  transmit 0.5  ambient rgb(0, 0.1, 0.2)  emission 3
    diffuse 1.25  brilliance 2  phong 0.5  phong_size 80  specular 0.75  roughness 0.01
    metallic 0.5  conserve_energy true  ior 1.25
    fade_distance 2  fade_power 1001  fade_color rgb(0.5, 0.25, 0)
    reflection { min 0.125  max rgb(1, 2, 3)  falloff 4  fresnel true  metallic 1 }
  }
})");
  EXPECT_EQ(m.filter, 0.25);
  EXPECT_EQ(m.transmit, 0.5);
  EXPECT_EQ(opacity(m), 0.25);
  EXPECT_EQ(m.ambient, (Rgbd{0, 0.1, 0.2}));
  EXPECT_EQ(m.emission, Rgbd(3.0));
  EXPECT_EQ(m.diffuse, 1.25);
  EXPECT_EQ(m.brilliance, 2);
  EXPECT_EQ(m.phong, 0.5);
  EXPECT_EQ(m.phong_size, 80);
  EXPECT_EQ(m.specular, 0.75);
  EXPECT_EQ(m.roughness, 0.01);
  EXPECT_EQ(m.metallic, 0.5);
  EXPECT_EQ(m.reflection.min, Rgbd(0.125));
  EXPECT_EQ(m.reflection.max, (Rgbd{1, 2, 3}));
  EXPECT_EQ(m.reflection.falloff, 4);
  EXPECT_TRUE(m.reflection.fresnel);
  EXPECT_EQ(m.reflection.metallic, 1);
  EXPECT_TRUE(m.conserve_energy);
  EXPECT_EQ(m.ior, 1.25);
  EXPECT_EQ(m.fade_distance, 2);
  EXPECT_EQ(m.fade_power, 1001);
  EXPECT_EQ(m.fade_color, (Rgbd{0.5, 0.25, 0}));
}

TEST(PovFinish, OneReflectionIsTheSameAtEveryAngle) {
  const PovReflection r = finish_of("sphere { material pov_finish { reflection 0.3 } }").reflection;
  EXPECT_EQ(r.min, Rgbd(0.3));
  EXPECT_EQ(r.max, Rgbd(0.3));
  EXPECT_FALSE(r.fresnel);
  const PovReflection gold =
      finish_of("sphere { material pov_finish { reflection rgb(1, 0.8, 0.3) } }").reflection;
  EXPECT_EQ(gold.max, (Rgbd{1, 0.8, 0.3}));
}

TEST(PovFinish, IsVaried) {
  const PovFinish m = finish_of(R"(
let base = pov_finish { color rgb(0.5)  phong 0.5  reflection 0.25  ior 1.5 }
sphere { material base { phong_size 10  filter 0.5 } })");
  EXPECT_EQ(m.phong, 0.5);
  EXPECT_EQ(m.phong_size, 10);
  EXPECT_EQ(m.filter, 0.5);
  EXPECT_EQ(m.ior, 1.5);
  EXPECT_EQ(m.reflection.max, Rgbd(0.25));
}

TEST(PovFinish, EqualOnesAreOneAndEveryFieldTellsThemApart) {
  const auto materials = [](const std::string& properties) {
    Evaluated e;
    evaluate_into(e, kCamera + std::string("sphere { material pov_finish { } }\n") +
                         "sphere { material pov_finish { " + properties + " } }");
    EXPECT_TRUE(e.result.scene) << e.diagnostics();
    return e.result.scene ? e.scene().materials.size() : 0;
  };
  EXPECT_EQ(materials("phong 0"), 1U);
  for (const char* other :
       {"color rgb(0.1)", "filter 0.1", "transmit 0.1", "ambient 0", "emission 1", "diffuse 1",
        "brilliance 2", "phong 1", "phong_size 1", "specular 1", "roughness 1", "metallic 1",
        "reflection 1", "reflection { }", "conserve_energy true", "ior 2",
        "fade_power 1  fade_distance 1"}) {
    EXPECT_EQ(materials(other), 2U) << other;
  }
}

// Its emission goes with its colour, so it is not the radiance of the other materials.
TEST(PovFinish, EmissionIsOfTheFinish) {
  Evaluated e;
  evaluate_into(e, kCamera + std::string("sphere { material pov_finish { emission 2 } }"));
  EXPECT_EQ(e.scene().materials.at(0).emission, Rgbd{});
}

TEST(PovFinish, DeadUsesCallForNothing) {
  const auto effects = [](const std::string& properties) {
    Evaluated e;
    evaluate_into(e, kCamera + ("sphere { material pov_finish { " + properties + " } }"));
    EXPECT_TRUE(e.result.scene) << e.diagnostics();
    return derive_effects(e.scene());
  };
  const EffectSet plain = effects("ambient 0  diffuse 0");
  for (const Effect effect : {Effect::pov_finish, Effect::pov_glow, Effect::pov_reflection,
                              Effect::pov_transmission, Effect::point_lights}) {
    EXPECT_FALSE(plain.has(effect)) << static_cast<int>(effect);
  }
  EXPECT_FALSE(effects("color rgb(0)  filter 0.5").has(Effect::pov_transmission));
  EXPECT_FALSE(effects("color rgb(0)").has(Effect::pov_glow));
  EXPECT_FALSE(effects("transmit 1").has(Effect::pov_finish)) << "all of it is clear";
  EXPECT_TRUE(effects("transmit 1  phong 1").has(Effect::pov_finish));
  EXPECT_TRUE(effects("").has(Effect::pov_finish));
  EXPECT_TRUE(effects("").has(Effect::pov_glow));
  EXPECT_TRUE(effects("").has(Effect::point_lights));
  EXPECT_TRUE(effects("reflection { }").has(Effect::pov_reflection));
  EXPECT_TRUE(effects("color rgb(0)  transmit 0.5").has(Effect::pov_transmission));
  EXPECT_TRUE(effects("filter 0.5").has(Effect::tinted_shadows));
}

}  // namespace
}  // namespace alhazen::parser
