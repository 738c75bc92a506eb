// A whole small scene, record by record.
#include <gtest/gtest.h>

#include "support.h"

namespace alhazen::parser {
namespace {

TEST(Evaluate, SketchOfTheDesign) {
  Evaluated e;
  evaluate_into(e, R"(
param ball_ior = 1.5 in 1.0 .. 3.0 "index of refraction of the ball"
camera perspective { position <0, 1.5, -6>  look_at <0, 1, 0>  fov 40deg }
light point { position <5, 8, -5>  intensity rgb(60) }
let ball = glass { ior ball_ior  absorption rgb(0.1, 0.02, 0.02) }
plane  { normal y  material diffuse { color checker(rgb(0.9), rgb(0.1)) } }
sphere { center <0, 1, 0>  radius 1  material ball }
for i in 0 .. 12 {
  sphere { center <3*cos(i*30deg), 0.3, 3*sin(i*30deg)>  radius 0.3  material mirror { color hsv(i/12, 0.6, 0.9) } }
}
)");
  ASSERT_TRUE(e.result.scene) << e.diagnostics();
  EXPECT_TRUE(e.sink.diagnostics().empty()) << e.diagnostics();
  const Scene& scene = e.scene();
  EXPECT_EQ(scene.shapes.size(), 14U);
  EXPECT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.materials.size(), 14U);
  EXPECT_EQ(scene.materials[scene.shapes[1].material].name, "ball");
  EXPECT_EQ(std::get<Glass>(scene.materials[scene.shapes[1].material].scattering).ior, 1.5);
  EXPECT_EQ(std::get<PerspectiveCamera>(scene.camera.projection).fov_deg, 40);
  // The fourth of the ring stands at 90 degrees: its x is exactly 0.
  EXPECT_EQ(std::get<Sphere>(scene.shapes[5].geometry).center, (Vec3d{0, 0.3, 3}));
  EXPECT_EQ(scene.shapes.name(5), "sphere 5");
  ASSERT_EQ(e.result.params.size(), 1U);
  EXPECT_EQ(e.result.params[0].range, "1 .. 3");
}

}  // namespace
}  // namespace alhazen::parser
