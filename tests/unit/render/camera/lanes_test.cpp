// tests: camera rays on lanes and one by one: the same bits.
#include "render/camera/camera_kernel.h"
#include "unit/render/lanes_agree.h"

namespace alhazen::render {
namespace {

constexpr int kWidth = 37, kHeight = 20;

CameraFrame frame() {
  CameraFrame frame;
  frame.position = {1, 2, 3};
  frame.right = {0.8, 0, 0.6};
  frame.up = {0, 1, 0};
  frame.forward = {-0.6, 0, 0.8};
  return frame;
}

// Column, row, offsets, and the place on the lens, its centre, rim and diagonals among them.
double argument(int i, int j) {
  if (j < 2) return std::floor((j == 0 ? kWidth : kHeight) * drawn(i, j));
  return j < 4 ? drawn(i, j) - 0.5 : drawn_from({0, 0.5, 0.25, 0.75, 0.99999994}, i, j);
}

void expect_rays_agree(const Camera& camera) {
  expect_all_lanes_agree<6>(argument, [&](auto& out, const auto& in) {
    using Real = std::decay_t<decltype(in[0])>;
    const CameraKernel<ScalarOf<Real>> kernel(camera, kWidth, kHeight);
    const FilmPoint<Real> film{static_cast<IntOf<Real>>(in[0]), static_cast<IntOf<Real>>(in[1]),
                               in[2], in[3]};
    const CameraRay<Real> ray = kernel.ray(film, in[4], in[5]);
    put(out, ray.origin);
    put(out, ray.direction);
  });
}

TEST(CameraLanes, Pinhole) {
  expect_rays_agree({frame(), PerspectiveCamera{60, std::nullopt}});
}
TEST(CameraLanes, Lens) {
  expect_rays_agree({frame(), PerspectiveCamera{60, ThinLens{0.25, 7}}});
}
TEST(CameraLanes, Parallel) {
  expect_rays_agree({frame(), OrthographicCamera{4}});
}

}  // namespace
}  // namespace alhazen::render
