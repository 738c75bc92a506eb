#include "app/cli/camera_matrices.h"

#include <gtest/gtest.h>

namespace alhazen {
namespace {

struct Ndc {
  double x, y;
};

Ndc project(const Camera& camera, const RenderSettings& settings, Vec3d p) {
  const auto m = ndc_from_world(camera, settings);
  const auto row = [&](std::size_t i) {
    return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3];
  };
  return {row(0) / row(3), row(1) / row(3)};
}

Camera camera_at(Vec3d position) {
  Camera camera;
  camera.frame.position = position;
  return camera;
}

// A handful of products and sums of numbers around one, each rounded once.
constexpr double kRounding = 16 * 0x1p-53;

TEST(CameraMatrices, PerspectiveShowsItsFieldOfViewFromEdgeToEdge) {
  Camera camera = camera_at({1, 2, 3});
  camera.projection = PerspectiveCamera{90, {}};
  RenderSettings settings;
  settings.width = 200;
  settings.height = 100;
  // At distance 4 a picture of 90 degrees is 8 wide and, half as high as wide, 4 high.
  const Ndc centre = project(camera, settings, {1, 2, 7});
  EXPECT_NEAR(centre.x, 0.5, kRounding);
  EXPECT_NEAR(centre.y, 0.5, kRounding);
  const Ndc upper_left = project(camera, settings, {-3, 4, 7});
  EXPECT_NEAR(upper_left.x, 0, kRounding);
  EXPECT_NEAR(upper_left.y, 0, kRounding);
  const Ndc lower_right = project(camera, settings, {5, 0, 7});
  EXPECT_NEAR(lower_right.x, 1, kRounding);
  EXPECT_NEAR(lower_right.y, 1, kRounding);
}

TEST(CameraMatrices, OrthographicShowsItsWidthAtAnyDistance) {
  Camera camera = camera_at({0, 0, -5});
  camera.projection = OrthographicCamera{6};
  RenderSettings settings;
  settings.width = 300;
  settings.height = 100;
  for (const double z : {-4.0, 0.0, 100.0}) {
    const Ndc upper_left = project(camera, settings, {-3, 1, z});
    EXPECT_NEAR(upper_left.x, 0, kRounding);
    EXPECT_NEAR(upper_left.y, 0, kRounding);
  }
}

TEST(CameraMatrices, CameraFrameHasThePositionAtItsOrigin) {
  CameraFrame frame;
  frame.position = {1, 2, 3};
  frame.right = {0, 0, -1};
  frame.forward = {1, 0, 0};
  const Affined map = camera_from_world(frame);
  EXPECT_EQ(map.point({1, 2, 3}), Vec3d(0, 0, 0));
  EXPECT_EQ(map.point({3, 2, 3}), Vec3d(0, 0, 2));
  EXPECT_EQ(map.point({1, 2, 2}), Vec3d(1, 0, 0));
}

}  // namespace
}  // namespace alhazen
