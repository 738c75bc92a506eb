// tests: the matrices for EXR agree with the rays.
#include "render/camera/camera_matrices.h"

#include <gtest/gtest.h>

#include "core/math/transform.h"
#include "render/camera/camera_kernel.h"

namespace alhazen::render {
namespace {

std::array<double, 4> row_times(Vec3d p, const RowMatrix& m) {
  std::array<double, 4> result{};
  for (std::size_t j = 0; j < 4; ++j)
    result[j] = p.x * m[0][j] + p.y * m[1][j] + p.z * m[2][j] + m[3][j];
  return result;
}

CameraFrame turned_frame() {
  const Affined turn = rotation({1, 2, 3}, 40);
  return {{3, -2, 5}, turn.vector({1, 0, 0}), turn.vector({0, 1, 0}), turn.vector({0, 0, 1})};
}

// Every point of the ray through a film point has that film point's place in the picture.
void expect_places(const Camera& camera, int width, int height) {
  const RowMatrix to_ndc = world_to_ndc(camera, width, height);
  const CameraKernel<double> kernel(camera, width, height);
  for (const double t : {0.5, 2.0, 100.0}) {
    for (int column = 0; column < width; column += 5) {
      const auto ray = kernel.ray({column, 3, 0.25, -0.25}, 0, 0);
      const Vec3d world = camera.frame.position + ray.origin + t * ray.direction;
      const auto ndc = row_times(world, to_ndc);
      EXPECT_NEAR(ndc[0] / ndc[3], (column + 0.75) / width, 1e-12);
      EXPECT_NEAR(ndc[1] / ndc[3], 3.25 / height, 1e-12);
    }
  }
}

TEST(CameraMatrices, NdcIsThePlaceInThePicture) {
  Camera camera;
  camera.frame = turned_frame();
  camera.projection = PerspectiveCamera{50, std::nullopt};
  expect_places(camera, 64, 36);
  camera.projection = OrthographicCamera{7};
  expect_places(camera, 64, 36);
}

TEST(CameraMatrices, CameraSpaceLooksAlongZ) {
  const CameraFrame frame = turned_frame();
  const RowMatrix to_camera = world_to_camera(frame);
  const auto ahead = row_times(frame.position + 4.0 * frame.forward + 2.0 * frame.right, to_camera);
  EXPECT_NEAR(ahead[0], 2, 1e-14);
  EXPECT_NEAR(ahead[1], 0, 1e-14);
  EXPECT_NEAR(ahead[2], 4, 1e-14);
  EXPECT_EQ(ahead[3], 1);
}

}  // namespace
}  // namespace alhazen::render
