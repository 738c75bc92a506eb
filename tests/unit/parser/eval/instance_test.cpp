// When a group is kept once for several places, and that whoever asks by id cannot tell.
#include <gtest/gtest.h>

#include "support.h"

namespace alhazen::parser {
namespace {

Scene scene_of(const std::string& text) {
  Evaluated e;
  evaluate_into(e, kCamera + text);
  EXPECT_TRUE(e.result.scene) << e.diagnostics();
  return e.result.scene.value_or(Scene{});
}

// Twenty balls, a box and a named ball; one of them with a material and a transform of its own.
const std::string kTower = R"(
fn tower() {
  for i in 0..20 { sphere { center y*i  radius 0.5 } }
  group { box { min <-1, -1, -1>  max <1, 0, 1>  rotate y*30deg  material mirror { } }  name "base" }
  sphere { name "top" }
}
)";

// The same by id.
void expect_alike(const Scene& kept, const Scene& written) {
  ASSERT_EQ(kept.shapes.size(), written.shapes.size());
  for (ShapeId id = 0; id < kept.shapes.size(); ++id) {
    const Shape a = kept.shapes[id], b = written.shapes[id];
    EXPECT_EQ(kept.shapes.name(id), written.shapes.name(id)) << id;
    EXPECT_EQ(a.geometry.index(), b.geometry.index()) << id;
    EXPECT_EQ(a.world_from_object, b.world_from_object) << id;
    EXPECT_EQ(kept.materials[a.material].scattering.index(),
              written.materials[b.material].scattering.index())
        << id;
    EXPECT_EQ(kept.materials[a.material].name, written.materials[b.material].name) << id;
  }
}

TEST(Instances, AGroupByNameIsKeptOnce) {
  const std::string places = R"(
sphere { }
let gold = metal { preset gold }
object T { translate x*3 }
sphere { }
group { object T { translate x*6  material gold }  name "row" }
object T { rotate y*20deg  translate x*9 }
sphere { }
)";
  const auto with = [&](const std::string& name) {
    std::string text = places;
    for (std::size_t at; (at = text.find("object T")) != std::string::npos;)
      text.replace(at, 8, name);
    return text;
  };
  const Scene kept = scene_of(kTower + "let s = tower()\n" + with("object s"));
  // Each call makes a group of its own.
  const Scene written = scene_of(kTower + with("tower()"));
  EXPECT_EQ(kept.shapes.instance_count(), 3U);
  ASSERT_EQ(kept.shapes.prototypes().size(), 1U);
  EXPECT_EQ(kept.shapes.prototypes()[0].size(), 22U);
  EXPECT_EQ(kept.shapes.singles().size(), 3U);
  EXPECT_EQ(written.shapes.instance_count(), 0U);
  expect_alike(kept, written);
}

TEST(Instances, SmallOnesAndThoseOfOnePlaceAreWrittenOut) {
  EXPECT_EQ(scene_of("let s = group { sphere { }  box { min <0,0,0>  max <1,1,1> } }\n"
                     "for i in 0..5 { object s { translate x*i } }")
                .shapes.instance_count(),
            0U);
  EXPECT_EQ(scene_of(kTower + "let s = tower()\nobject s { translate x }").shapes.instance_count(),
            0U);
  EXPECT_EQ(scene_of(kTower + "let s = tower()\nobject s  object s").shapes.instance_count(), 0U)
      << "not moved";
}

TEST(Instances, LightsAndPlanesAreThereEachTime) {
  const Scene s = scene_of(R"(
let lamp = group {
  for i in 0..20 { sphere { center y*i } }
  light sphere { center y*30  radius 1  radiance rgb(5)  visible true }
  plane { normal y  offset -1 }
  for i in 0..30 { sphere { center x*i } }
  sphere { material mirror { } }
  translate z
}
object lamp { translate x*100 }
object lamp { scale 2  translate x*200 }
)");
  EXPECT_EQ(s.shapes.prototypes().size(), 2U);
  EXPECT_EQ(s.shapes.instance_count(), 4U);
  ASSERT_EQ(s.lights.size(), 3U) << "and the one of every scene here";
  EXPECT_EQ(std::get<SphereLight>(s.lights[1].source).center, (Vec3d{100, 30, 1}));
  EXPECT_EQ(std::get<SphereLight>(s.lights[2].source).radius, 2);
  // Balls, the lamp's own surface, the plane, balls.
  const ShapeId lamp = s.lights[1].visible_shape;
  EXPECT_EQ(lamp, 20U);
  EXPECT_EQ(s.shapes[lamp].light, 1U);
  EXPECT_TRUE(std::holds_alternative<Plane>(s.shapes[lamp + 1].geometry));
  EXPECT_EQ(s.shapes.size(), 2U * (20 + 1 + 1 + 31));
}

TEST(Instances, GroupsWithinAreWrittenOutInside) {
  const Scene s = scene_of(kTower + R"(
let t = tower()
let row = group { for i in 0..10 { object t { translate x*i } } }
object row { translate y }
object row { translate z }
)");
  ASSERT_EQ(s.shapes.prototypes().size(), 1U);
  EXPECT_EQ(s.shapes.prototypes()[0].size(), 220U);
  EXPECT_EQ(s.shapes.instance_count(), 2U);
}

TEST(Instances, AGroupTooLargeIsKeptInParts) {
  const Scene s = scene_of(kTower + R"(
let t = tower()
let forest = group { for i in 0..4000 { object t { translate x*(i + 1) } }  sphere { } }
object forest { translate y }
object forest { translate z }
)");
  ASSERT_EQ(s.shapes.prototypes().size(), 1U);
  EXPECT_EQ(s.shapes.prototypes()[0].size(), 22U);
  EXPECT_EQ(s.shapes.instance_count(), 8000U);
  EXPECT_EQ(s.shapes.singles().size(), 2U);
}

// What costs a transform each does not count as shapes.
TEST(Instances, AreWithinTheLimitOfShapes) {
  Evaluated e;
  EvalOptions options;
  options.limits.shapes = 3000;
  evaluate_into(e, kCamera + kTower + R"(
let s = tower()
for i in 0..2000 { object s { translate x*i } }
)",
                options);
  ASSERT_TRUE(e.result.scene) << e.diagnostics();
  EXPECT_EQ(e.result.scene->shapes.size(), 44000U);
}

}  // namespace
}  // namespace alhazen::parser
