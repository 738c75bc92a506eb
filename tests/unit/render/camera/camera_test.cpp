// tests: rays of the cameras: where they go, that mirrored pixels mirror them bit for bit, and that
// the plane in focus is sharp (docs/numerics.md E1, E3).
#include <random>

#include "core/math/elementary.h"
#include "render/camera/camera_kernel.h"
#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

Camera perspective(double fov_deg, CameraFrame frame = {}) {
  Camera camera;
  camera.frame = frame;
  camera.projection = PerspectiveCamera{fov_deg, std::nullopt};
  return camera;
}

Camera thin_lens(double fov_deg, double aperture, double focus) {
  Camera camera;
  camera.projection = PerspectiveCamera{fov_deg, ThinLens{aperture, focus}};
  return camera;
}

// Turned about x, so that left and right stay mirror images.
CameraFrame tilted_frame(double angle_deg) {
  const double s = sin_deg(angle_deg), c = cos_deg(angle_deg);
  return {{5, 6, 7}, {1, 0, 0}, {0, c, s}, {0, -s, c}};
}

TEST(Perspective, PixelCentresAreThoseOfPovRay) {
  Worst worst("direction of pixel centres against the formula", 4, "eps");
  const int width = 64, height = 48;
  const CameraKernel<double> camera(perspective(60), width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto ray = camera.ray({column, row}, 0, 0);
      // ((i + 1/2)/W - 1/2) right + (1/2 - (j + 1/2)/H) up, with |right| = 2 tan(fov/2).
      const double w = 2 * tan_deg(30), h = w * height / width;
      const Vec3d expected = normalized(
          Vec3d(((column + 0.5) / width - 0.5) * w, (0.5 - (row + 0.5) / height) * h, 1));
      worst.add(length(ray.direction - expected) / 0x1p-53);
      ASSERT_EQ(ray.origin, Vec3d(0, 0, 0));
    }
  }
}

TEST(Perspective, TheBordersSpanTheFieldOfView) {
  Worst worst("angle between the side borders / fov - 1", 1e-9);
  for (const double fov : {1e-6, 1e-3, 1.0, 60.0, 120.0, 179.0, 179.99}) {
    const int width = 100, height = 50;
    const CameraKernel<double> camera(perspective(fov), width, height);
    // The middle of the left and the right border of the picture.
    const auto left = camera.ray({0, 25, -0.5, -0.5}, 0, 0);
    const auto right = camera.ray({99, 25, 0.5, -0.5}, 0, 0);
    const double angle = atan2_deg(length(cross(left.direction, right.direction)),
                                   dot(left.direction, right.direction));
    worst.add(std::fabs(angle / fov - 1));
    EXPECT_TRUE(is_finite(left.direction));
    EXPECT_NEAR(length(left.direction), 1, 4 * 0x1p-53);
  }
}

// An object centred on the axis covers the pixels that its analytic silhouette covers: a sphere of
// angular radius a seen at the picture's centre is a disc of radius tan a in the plane at 1.
TEST(Perspective, TheSilhouetteOfASphere) {
  const int size = 100;
  for (const double fov : {1e-6, 1.0, 90.0, 179.0}) {
    const CameraKernel<double> camera(perspective(fov), size, size);
    const double plane_radius = 0.3 * 2 * tan_deg(fov / 2);  // 30 pixels
    const double sine = plane_radius / std::sqrt(1 + plane_radius * plane_radius);
    int wrong = 0;
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const Vec3d d = camera.ray({column, row}, 0, 0).direction;
        const bool inside = length(Vec3d(d.x, d.y, 0)) < sine;
        const double pixels = std::hypot(column - 49.5, row - 49.5);
        wrong += inside != (pixels < 30);
      }
    }
    EXPECT_EQ(wrong, 0) << fov;
  }
}

template <class Real>
void expect_mirrored(const Camera& scene_camera, int width, int height) {
  const CameraKernel<Real> camera(scene_camera, width, height);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for (int row = 0; row < height; row += 7) {
    for (int column = 0; column < width; ++column) {
      const Real x = static_cast<Real>(offset(random)), y = static_cast<Real>(offset(random));
      const auto left = camera.ray({column, row, x, y}, Real(0.5), Real(0.5));
      const auto right = camera.ray({width - 1 - column, row, -x, y}, Real(0.5), Real(0.5));
      ASSERT_EQ(left.direction,
                Vec3<Real>(-right.direction.x, right.direction.y, right.direction.z));
      ASSERT_EQ(left.origin, Vec3<Real>(-right.origin.x, right.origin.y, right.origin.z));
    }
  }
}

TEST(Camera, MirroredPixelsHaveMirroredRays) {
  Camera orthographic;
  orthographic.frame = tilted_frame(20);
  orthographic.projection = OrthographicCamera{3};
  for (const int width : {64, 101}) {
    expect_mirrored<double>(perspective(47.3, tilted_frame(33)), width, 35);
    expect_mirrored<float>(perspective(47.3, tilted_frame(33)), width, 35);
    expect_mirrored<double>(orthographic, width, 35);
    expect_mirrored<float>(orthographic, width, 35);
  }
}

TEST(Camera, PrecisionsSeeOneCamera) {
  const CameraKernel<float> single(perspective(50), 640, 360);
  const CameraKernel<double> normal(perspective(50), 640, 360);
  const auto f = single.ray({17, 300, 0.25f, -0.125f}, 0, 0);
  const auto d = normal.ray({17, 300, 0.25, -0.125}, 0, 0);
  EXPECT_LT(length(Vec3d(f.direction) - d.direction), 4 * 0x1p-24);
}

TEST(Orthographic, RaysAreParallelAndTheirOriginsAWidthApart) {
  Camera scene_camera;
  scene_camera.frame = {{100, 200, 300}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene_camera.projection = OrthographicCamera{8};
  const CameraKernel<double> camera(scene_camera, 16, 8);
  EXPECT_FALSE(camera.has_lens());
  const auto corner = camera.ray({0, 0, -0.5, -0.5}, 0, 0);
  EXPECT_EQ(corner.origin, Vec3d(-4, 2, 0));
  EXPECT_EQ(corner.direction, Vec3d(0, 0, 1));
  EXPECT_EQ(camera.ray({15, 7, 0.5, 0.5}, 0, 0).origin, Vec3d(4, -2, 0));
}

TEST(ThinLens, ThePlaneInFocusIsSharp) {
  Worst worst("thin lens: spread in the plane in focus / its distance", 4, "eps");
  const double focus = 7;
  const CameraKernel<double> camera(thin_lens(40, 0.5, focus), 64, 48);
  const CameraKernel<double> pinhole(perspective(40), 64, 48);
  EXPECT_TRUE(camera.has_lens());
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 10000; ++i) {
    const FilmPoint<double> film{i % 64, i % 48, unit(random) - 0.5, unit(random) - 0.5};
    const auto ray = camera.ray(film, unit(random), unit(random));
    const Vec3d d = pinhole.ray(film, 0, 0).direction;
    const Vec3d sharp = (focus / d.z) * d;
    const Vec3d hit = ray.origin + (focus / ray.direction.z) * ray.direction;
    worst.add(length(hit - sharp) / focus / 0x1p-53);
    ASSERT_LE(length(ray.origin), 0.5 * (1 + 1e-15));
    ASSERT_EQ(ray.origin.z, 0);
  }
}

TEST(ThinLens, WithoutApertureIsAPinhole) {
  const CameraKernel<double> camera(thin_lens(40, 0, 7), 64, 48);
  EXPECT_FALSE(camera.has_lens());
  EXPECT_EQ(camera.ray({3, 4}, 0.2, 0.9).origin, Vec3d(0, 0, 0));
}

TEST(Disc, IsCoveredEvenly) {
  // Of a 256 x 256 grid, the share inside of radius r is r^2, in the half plane x < 0 a half.
  int inside = 0, left = 0;
  double second_moment = 0;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const auto p = disc_from_square((i + 0.5) / 256, (j + 0.5) / 256);
      const double squared = p.x * p.x + p.y * p.y;
      ASSERT_LE(squared, 1);
      inside += squared < 0.25;
      left += p.x < 0;
      second_moment += p.x * p.x;
    }
  }
  EXPECT_NEAR(inside / 65536.0, 0.25, 1e-12);  // squares go to rings: exact on the grid
  EXPECT_EQ(left, 32768);
  EXPECT_NEAR(second_moment / 65536, 0.25, 1e-5);
  const auto centre = disc_from_square(0.5, 0.5);
  EXPECT_EQ(centre.x, 0);
  EXPECT_EQ(centre.y, 0);
}

}  // namespace
}  // namespace alhazen::render
