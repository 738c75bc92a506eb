// Mirrors and recursion against closed forms (docs/numerics.md, group D).
#include "core/math/elementary.h"
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::SceneBuilder;

// D3: two parallel mirrors of reflectance r that glow with a: a (1 - r^(N+1)) / (1 - r).
TEST(Mirror, ParallelMirrorsSumAGeometricSeries) {
  for (const int depth : {0, 1, 5, 60}) {
    SceneBuilder b;
    const double r = 0.9, a = 0.25;
    const MaterialId worn = b.material(Mirror{b.color(Rgbd(r))}, Rgbd(a));
    b.add(Plane{{0, 0, -1}, -1}, worn);
    b.add(Plane{{0, 0, 1}, -1}, worn);
    b.scene.settings.max_depth = depth;
    const double expected = a * (1 - power(r, depth + 1.0)) / (1 - r);
    EXPECT_NEAR(central_radiance(b, {0, 0, 0}), expected, 1e-13);
  }
}

// D1: from a closed room of mirrors no ray ever gets out, however often it is reflected.
TEST(Mirror, ClosedRoomsDoNotLeak) {
  const double scales[] = {0x1p-300, 1.0, 0x1p300};
  for (const double s : scales) {
    const Geometry rooms[] = {Sphere{{0, 0, 0}, s}, Box{{-s, -s, -s}, {s, s, s}},
                              Cylinder{{0, -s, 0}, {0, s, 0}, s, true},
                              Cone{{0, -s, 0}, {0, s, 0}, 2 * s, s / 2, true}};
    for (const Geometry& room : rooms) {
      SceneBuilder b;
      b.background(1000);
      b.add(room, b.material(Mirror{b.color(Rgbd(1))}, Rgbd(0.01)));
      b.scene.settings.max_depth = 200;
      b.scene.settings.width = b.scene.settings.height = 40;
      b.look(s * Vec3d(0.1, 0.2, -0.3), normalized(Vec3d(0, 0.1, 1)), normalized(Vec3d(0, 1, -0.1)),
             70);
      double worst = 0;
      for (const double value : pixels_of(b.scene))
        worst = std::max(worst, std::abs(value - 2.01));
      EXPECT_LE(worst, 1e-12) << kind_name(room) << " of size " << s;
    }
  }
}

// The same room made of six planes: each corner is the meeting of three shapes.
TEST(Mirror, RoomOfSixPlanesDoesNotLeak) {
  SceneBuilder b;
  b.background(1000);
  const MaterialId worn = b.material(Mirror{b.color(Rgbd(1))}, Rgbd(0.01));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3d normal;
      normal[axis] = -sign;
      b.add(Plane{normal, -1}, worn);
    }
  }
  b.scene.settings.max_depth = 200;
  b.scene.settings.width = b.scene.settings.height = 41;  // odd: the centre runs along an axis
  b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90);            // the diagonals run into the corners
  double worst = 0;
  for (const double value : pixels_of(b.scene))
    worst = std::max(worst, std::abs(value - 2.01));
  EXPECT_LE(worst, 1e-12);
}

TEST(Mirror, MetalAtNormalIncidenceIsFresnels) {
  SceneBuilder b;
  b.background(1);
  b.add(Plane{{0, 0, -1}, -1}, b.material(Metal{Rgbd(0.2, 1, 2), Rgbd(3, 2, 0)}));
  b.scene.settings.width = b.scene.settings.height = 1;
  b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e-6);
  const std::vector<double> rgb = pixels_of(b.scene);
  const auto normal = [](double n, double k) {
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  };
  EXPECT_NEAR(rgb[0], normal(0.2, 3), 1e-15);
  EXPECT_NEAR(rgb[1], normal(1, 2), 1e-15);
  EXPECT_NEAR(rgb[2], normal(2, 0), 1e-15);
}

// A varnished white board under an even sky, mirrored and diffuse together, gives back everything.
TEST(Coat, WhiteBaseUnderClearCoatConservesLight) {
  for (const double angle : {0.0, 40.0, 80.0}) {
    SceneBuilder b;
    b.background(1);
    b.light(AmbientLight{Rgbd(1)});
    b.add(Plane{{0, 1, 0}, 0}, b.material(Coat{1.5, Rgbd(0), b.color(Rgbd(1))}));
    b.scene.settings.width = b.scene.settings.height = 1;
    const Vec3d forward(sin_deg(angle), -cos_deg(angle), 0);
    b.look(-5 * forward, forward, {cos_deg(angle), sin_deg(angle), 0}, 1e-3);
    EXPECT_NEAR(pixels_of(b.scene)[0], 1, 1e-13) << angle;
  }
}

// D4: the stack does not grow with depth; 100 000 reflections are 100 000 turns of a loop.
TEST(Mirror, DepthOfAHundredThousandRuns) {
  SceneBuilder b;
  b.add(Sphere{{0, 0, 0}, 1}, b.material(Mirror{b.color(Rgbd(1))}, Rgbd(1)));
  b.scene.settings.max_depth = 100000;
  EXPECT_EQ(central_radiance(b, {0.1, 0.2, 0.3}), 100001);
}

}  // namespace
}  // namespace alhazen::render
