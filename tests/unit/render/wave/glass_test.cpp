// Glass against closed forms (docs/numerics.md, groups B and C).
#include "core/math/elementary.h"
#include "render/surface/fresnel.h"
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::SceneBuilder;

constexpr double kNormalReflectance = 0.04;  // ((1.5 - 1) / (1.5 + 1))^2

// C5: along the axis each face reflects R. What leaves forward after k inner reflections adds
// (1 - R)^2 R^(2k), what comes back R + (1 - R)^2 R (1 + R^2 + ...); all of it sees the same sky.
TEST(Glass, BallInEvenSkyKeepsAllLightButTheTruncatedTail) {
  for (const int depth : {0, 1, 2, 3, 4, 8, 16, 40}) {
    SceneBuilder b;
    b.background(1);
    b.add(Sphere{{0, 0, 0}, 1}, b.glass(1.5));
    b.scene.settings.max_depth = depth;
    const double r = kNormalReflectance;
    // After the first meeting the ray inside carries 1 - R; each further meeting lets out 1 - R of
    // it.
    double expected = 0;
    if (depth >= 1) expected += r;
    double inside = 1 - r;
    for (int meeting = 2; meeting <= depth; ++meeting) {
      expected += inside * (1 - r);
      inside *= r;
    }
    EXPECT_NEAR(central_radiance(b, {0, 0, -5}), expected, 1e-14) << "depth " << depth;
  }
}

// C6: the whole ball, at every angle, total reflection never occurs from outside.
TEST(Glass, WhiteFurnaceOverTheWholePicture) {
  SceneBuilder b;
  b.background(1);
  b.add(Sphere{{0, 0, 0}, 1}, b.glass(1.5));
  b.scene.settings.max_depth = 200;
  b.scene.settings.width = b.scene.settings.height = 24;
  b.look({0, 0, -3}, {0, 0, 1}, {0, 1, 0}, 40);
  for (const double value : pixels_of(b.scene))
    EXPECT_NEAR(value, 1, 1e-12);
}

// Beer and Lambert through a pane of thickness 2 that has no interface.
TEST(Glass, AbsorptionIsExponentialInThickness) {
  SceneBuilder b;
  b.background(1);
  b.add(Box{{-5, -5, 0}, {5, 5, 2}}, b.glass(1, Rgbd(0.3, 1, 0)));
  b.scene.settings.width = b.scene.settings.height = 1;
  b.look({0, 0, -5}, {0, 0, 1}, {0, 1, 0}, 1e-3);
  const std::vector<double> rgb = pixels_of(b.scene);
  EXPECT_NEAR(rgb[0], exp_of(-0.6), 1e-15);
  EXPECT_NEAR(rgb[1], exp_of(-2.0), 1e-15);
  EXPECT_EQ(rgb[2], 1);
}

TEST(Glass, AbsorbingSkyInsideOfAnInfiniteMediumIsBlackOnlyWhereItAbsorbs) {
  SceneBuilder b;
  b.background(1);
  b.add(Plane{{0, 1, 0}, 10}, b.glass(1, Rgbd(0.1, 0, 0)));  // the camera is below: inside
  b.scene.settings.width = b.scene.settings.height = 1;
  b.look({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1e-3);
  const std::vector<double> rgb = pixels_of(b.scene);
  EXPECT_EQ(rgb[0], 0);
  EXPECT_EQ(rgb[1], 1);
}

// C1: no case in the code for an index of 1.
TEST(Glass, IndexOneIsInvisible) {
  const auto picture = [](bool with_balls) {
    SceneBuilder b;
    b.background(0.25);
    b.light(PointLight{{4, 8, -6}, Rgbd(200), Falloff::inverse_square});
    b.add(Plane{{0, 1, 0}, -1.5}, b.diffuse(0.8));
    b.add(Sphere{{0, 0, 2}, 1}, b.diffuse(0.5));
    if (with_balls) {
      const MaterialId nothing = b.glass(1);
      b.add(Sphere{{0.3, 0.1, -1}, 1}, nothing);
      b.add(Box{{-2, -1, -1}, {-1, 1, 1}}, nothing);
    }
    b.scene.settings.width = b.scene.settings.height = 48;
    b.look({0, 0, -6}, {0, 0, 1}, {0, 1, 0}, 50);
    return pixels_of(b.scene);
  };
  const std::vector<double> with = picture(true), without = picture(false);
  double worst = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    worst = std::max(worst, std::abs(with[i] - without[i]));
  }
  EXPECT_LE(worst, 1e-12);
}

// C7: the face where two boxes of one glass meet is no face.
TEST(Glass, TwoAbuttingBoxesAreOneBox) {
  const auto picture = [](bool split) {
    SceneBuilder b;
    b.scene.background.source =
        GradientBackground{{{-1, Rgbd(0.2, 0.1, 0)}, {1, Rgbd(0.4, 0.7, 1)}}};
    const MaterialId glass = b.glass(1.5, Rgbd(0.2, 0.1, 0.4));
    if (split) {
      b.add(Box{{-1, -1, -1}, {0.25, 1, 1}}, glass);
      b.add(Box{{0.25, -1, -1}, {1, 1, 1}}, glass);
    } else {
      b.add(Box{{-1, -1, -1}, {1, 1, 1}}, glass);
    }
    b.scene.settings.width = b.scene.settings.height = 48;
    const Vec3d forward = normalized(Vec3d(0.4, -0.3, 1));
    b.look(-4 * forward, forward, normalized(cross(forward, cross(Vec3d(0, 1, 0), forward))), 45);
    return pixels_of(b.scene);
  };
  const std::vector<double> split = picture(true), whole = picture(false);
  int bad = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    bad += std::abs(split[i] - whole[i]) > 1.0 / 255;
  EXPECT_EQ(bad, 0);
}

// Four boxes and eight: at their common edge and corner many faces share a point, and a ray along
// the seam meets them all there. None of the inner ones is an interface, and the walk past them
// ends.
TEST(Glass, ManyAbuttingBoxesAreOneBox) {
  const auto picture = [](int parts_y, int parts_z) {
    SceneBuilder b;
    b.scene.background.source =
        GradientBackground{{{-1, Rgbd(0.2, 0.1, 0)}, {1, Rgbd(0.4, 0.7, 1)}}};
    const MaterialId glass = b.glass(1.5, Rgbd(0.2, 0.1, 0.4));
    for (int x = 0; x < 2; ++x) {
      for (int y = 0; y < parts_y; ++y) {
        for (int z = 0; z < parts_z; ++z) {
          b.add(Box{{x - 1.0, 2.0 * y / parts_y - 1, 2.0 * z / parts_z - 1},
                    {x + 0.0, 2.0 * (y + 1) / parts_y - 1, 2.0 * (z + 1) / parts_z - 1}},
                glass);
        }
      }
    }
    b.scene.settings.width = b.scene.settings.height = 9;  // odd: the centre runs along the seams
    b.look({0, 0, -4}, {0, 0, 1}, {0, 1, 0}, 45);
    return pixels_of(b.scene);
  };
  const std::vector<double> whole = picture(1, 1);
  for (const auto& [y, z] : {std::pair{2, 1}, std::pair{1, 2}, std::pair{2, 2}}) {
    const std::vector<double> split = picture(y, z);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_NEAR(split[i], whole[i], 1.0 / 255) << y << " x " << z << ", value " << i;
    }
  }
}

// In an absorbing pipe with open ends the segment up to the first wall is absorbed, too.
TEST(Glass, CameraInsideOfAnOpenShapeIsInIt) {
  SceneBuilder b;
  b.background(1);
  b.scene.settings.max_depth = 1;
  b.add(Cylinder{{-9, 0, 0}, {9, 0, 0}, 2, false}, b.glass(1, Rgbd(0.3, 0, 0)));
  EXPECT_NEAR(central_radiance(b, {0, 0, 0}), exp_of(-0.6), 1e-14);
}

// Water reaches into the glass that holds it. Where they overlap the glass, of higher priority, is
// there, so that looking out of the overlap the only interface is the outer face of the glass.
TEST(Glass, PriorityDecidesWhereSolidsOverlap) {
  const auto looking_back = [](int glass_priority) {
    SceneBuilder b;
    b.background(1);
    b.scene.settings.max_depth = 1;
    b.add(Box{{-9, -9, 0}, {9, 9, 1}}, b.glass(1.5, {}, glass_priority));
    b.add(Box{{-9, -9, 0.5}, {9, 9, 2}}, b.glass(1.25));
    b.scene.settings.width = b.scene.settings.height = 1;
    b.look({0, 0, 0.75}, {0, 0, -1}, {0, 1, 0}, 1e-3);
    return pixels_of(b.scene)[0];
  };
  EXPECT_NEAR(looking_back(1), 1 - 0.04, 1e-15);
  // With the water on top there is a face at z = 0.5, and depth 1 ends behind it.
  EXPECT_EQ(looking_back(-1), 0);
}

TEST(Glass, CameraInsideSeesTheSkyThroughOneFace) {
  SceneBuilder b;
  b.background(1);
  b.scene.settings.max_depth = 1;
  b.add(Sphere{{0, 0, 0}, 1}, b.glass(1.5));
  EXPECT_NEAR(central_radiance(b, {0, 0, 0}), 1 - 0.04, 1e-15);
}

// Under 48 degrees the inside of a pane reflects totally: nothing gets through, nothing is lost.
TEST(Glass, TotalReflectionKeepsEverything) {
  const DielectricInterface<double> inside = dielectric_interface(cos_deg(48.0), 1.5);
  EXPECT_TRUE(inside.total_reflection);
  EXPECT_EQ(inside.reflectance, 1);
}

}  // namespace
}  // namespace alhazen::render
