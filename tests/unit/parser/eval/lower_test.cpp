// What blocks become: transforms against matrices, materials handed down and varied, equal records
// kept once, lights moved.
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
Affined world(const Scene& scene, std::size_t shape) {
  return scene.shapes[shape].world_from_object.value_or(Affined());
}

TEST(Transform, AppliesInTheOrderWritten) {
  const Scene s = scene_of(R"(
sphere { translate x  rotate z*90deg  scale 2 }
sphere { scale 2  translate x }
sphere { rotate <90deg, 90deg, 0> }
sphere { matrix [[0, 1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]] }
sphere { rotate about(y, 90deg) }
sphere { translate x  translate -x })");
  const Affined turn_z = rotation({0, 0, 1}, 90), turn_x = rotation({1, 0, 0}, 90);
  EXPECT_EQ(world(s, 0), scaling({2, 2, 2}) * (turn_z * translation({1, 0, 0})));
  EXPECT_EQ(world(s, 0).point({0, 0, 0}), (Vec3d{0, 2, 0}));
  EXPECT_EQ(world(s, 1).point({1, 1, 1}), (Vec3d{3, 2, 2}));
  // About x first, then about y.
  EXPECT_EQ(world(s, 2).point({0, 1, 0}), rotation({0, 1, 0}, 90).point(turn_x.point({0, 1, 0})));
  EXPECT_EQ(world(s, 3).point({1, 2, 3}), (Vec3d{7, 7, 10}));
  EXPECT_EQ(world(s, 4), rotation({0, 1, 0}, 90));
  EXPECT_FALSE(s.shapes[5].world_from_object) << "the identity is said by nothing";
}

TEST(Transform, GroupsComeAfterTheirContents) {
  const Scene s = scene_of(
      "group { sphere { translate x }  group { sphere { }  scale 2 }\n"
      "  rotate z*90deg }");
  EXPECT_EQ(world(s, 0).point({0, 0, 0}), (Vec3d{0, 1, 0}));
  EXPECT_EQ(world(s, 1).point({1, 0, 0}), (Vec3d{0, 2, 0}));
}

TEST(Material, IsHandedDownAndVaried) {
  const Scene s = scene_of(R"(
let base = glass { ior 1.3  priority 2 }
group {
  sphere { }
  sphere { material mirror { } }
  material base { ior 1.7 }
}
fn two() { sphere { }  sphere { material base } }
two() { material metal { preset gold } }
sphere { })");
  const auto& scattering = [&](std::size_t shape) -> const Scattering& {
    return s.materials[s.shapes[shape].material].scattering;
  };
  EXPECT_EQ(std::get<Glass>(scattering(0)).ior, 1.7);
  EXPECT_EQ(std::get<Glass>(scattering(0)).priority, 2);
  EXPECT_TRUE(std::holds_alternative<Mirror>(scattering(1)));
  EXPECT_EQ(std::get<Metal>(scattering(2)).n.r, 0.18299);
  EXPECT_EQ(std::get<Glass>(scattering(3)).ior, 1.3);
  EXPECT_TRUE(std::holds_alternative<Diffuse>(scattering(4)));
}

TEST(Material, EqualOnesAreOne) {
  const Scene s = scene_of(
      "for i in 0 .. 5 { sphere { material diffuse { color rgb(0.5) } } }\n"
      "sphere { material diffuse { color rgb(1) / 2 } }\n"
      "let unused = glass { }");
  EXPECT_EQ(s.materials.size(), 1U);
  EXPECT_EQ(s.textures.size(), 1U);
}

TEST(Texture, TransformsMoveThePattern) {
  const Scene s = scene_of(
      "sphere { material diffuse { color checker(rgb(1), rgb(0)) "
      "{ scale 0.5  translate x  mapping uv } } }");
  const Texture& t = s.textures.back();
  EXPECT_EQ(t.mapping, Mapping::uv);
  EXPECT_EQ(t.pattern_from_mapped.point({1.5, 0.5, 0}), (Vec3d{1, 1, 0}));
}

TEST(Light, AreaLightsAreSeenAndMove) {
  const Scene s = scene_of(R"(
group {
  light sphere { center x  radius 1  radiance rgb(3) }
  light rectangle { corner <0, 0, 0>  edge_u x  edge_v z  visible false }
  scale 2
}
light rectangle { corner <0, 0, 0>  edge_u x  edge_v z  scale <1, -1, 1> })");
  ASSERT_EQ(s.lights.size(), 4U);
  const auto& ball = std::get<SphereLight>(s.lights[1].source);
  EXPECT_EQ(ball.center, (Vec3d{2, 0, 0}));
  EXPECT_EQ(ball.radius, 2);
  const Shape& seen = s.shapes[s.lights[1].visible_shape];
  EXPECT_EQ(seen.light, 1U);
  EXPECT_TRUE(std::holds_alternative<Black>(s.materials[seen.material].scattering));
  EXPECT_EQ(s.materials[seen.material].emission, Rgbd(3.0));
  EXPECT_EQ(s.lights[2].visible_shape, kNoId);
  // It shone to cross(x, z) = -y; mirrored in y it shines to +y.
  const auto& mirrored = std::get<RectangleLight>(s.lights[3].source);
  EXPECT_EQ(cross(mirrored.edge_u, mirrored.edge_v), (Vec3d{0, 1, 0}));
}

TEST(Camera, FrameIsLeftHanded) {
  Evaluated e;
  evaluate_into(e,
                "camera perspective { position <0, 0, -5>  look_at <0, 0, 0>\n"
                "  lens { aperture 0.1  focus_on <3, 4, 1> } }\nlight ambient { }");
  ASSERT_TRUE(e.result.scene) << e.diagnostics();
  const CameraFrame& f = e.scene().camera.frame;
  EXPECT_EQ(f.right, (Vec3d{1, 0, 0}));
  EXPECT_EQ(f.up, (Vec3d{0, 1, 0}));
  EXPECT_EQ(f.forward, (Vec3d{0, 0, 1}));
  EXPECT_EQ(std::get<PerspectiveCamera>(e.scene().camera.projection).lens->focus_distance, 6);
}

TEST(Settings, AdaptiveSamplingHasRoomUnlessToldOtherwise) {
  const auto settings_of = [](const char* render) {
    Evaluated e;
    evaluate_into(e, std::string(kCamera) + render);
    return e.scene().settings;
  };
  EXPECT_EQ(settings_of("render { size <8, 8> }").samples, 16);
  EXPECT_EQ(settings_of("render { adaptive 0.01 }").samples, kAdaptiveSamples);
  EXPECT_EQ(settings_of("render { adaptive 0.01  samples 17 }").samples, 17);
  EXPECT_FALSE(settings_of("render { size <8, 8> }").max_error);
  EXPECT_EQ(settings_of("render { max_error 1/255 }").max_error->error, 1.0 / 255);
  EXPECT_EQ(settings_of("render { max_error 1/255 }").max_error->share, 0);
  EXPECT_EQ(settings_of("render { max_error 0.1  max_error_share 0.99 }").max_error->share, 0.99);
}

TEST(Names, SayThePathOfGroups) {
  const Scene s = scene_of("group { name \"table\"  sphere { name \"top\" }  sphere { } }");
  EXPECT_EQ(s.shapes.name(0), "table/top");
  EXPECT_EQ(s.shapes.name(1), "table/sphere 2");
}

TEST(Dump, IsStable) {
  const std::string text = "sphere { material diffuse { color checker(rgb(0.1), rgb(0.2)) } }";
  EXPECT_EQ(dump(scene_of(text)), dump(scene_of(text)));
  EXPECT_NE(dump(scene_of(text)).find("texture 2: checker 0 1 mapping object"), std::string::npos);
}

}  // namespace
}  // namespace alhazen::parser
