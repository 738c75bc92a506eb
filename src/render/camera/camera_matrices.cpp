// render/camera: the matrices of EXR's standard attributes worldToCamera and worldToNDC.
#include "render/camera/camera_matrices.h"

#include "core/base/overloaded.h"
#include "core/math/elementary.h"

namespace alhazen::render {
namespace {

RowMatrix product(const RowMatrix& a, const RowMatrix& b) {
  RowMatrix result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k)
        result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

}  // namespace

RowMatrix world_to_camera(const CameraFrame& frame) {
  const Vec3d r = frame.right, u = frame.up, f = frame.forward, p = frame.position;
  return {{{r.x, u.x, f.x, 0},
           {r.y, u.y, f.y, 0},
           {r.z, u.z, f.z, 0},
           {-dot(p, r), -dot(p, u), -dot(p, f), 1}}};
}

RowMatrix world_to_ndc(const Camera& camera, int width, int height) {
  const double aspect = static_cast<double>(width) / height;
  const RowMatrix ndc_from_camera = std::visit(
      Overloaded{
          [&](const PerspectiveCamera& c) -> RowMatrix {
            const double scale = 1 / (2 * tan_deg(c.fov_deg / 2));
            return {
                {{scale, 0, 0, 0}, {0, -scale * aspect, 0, 0}, {0.5, 0.5, 1, 1}, {0, 0, -1, 0}}};
          },
          [&](const OrthographicCamera& c) -> RowMatrix {
            return {{{1 / c.width, 0, 0, 0},
                     {0, -aspect / c.width, 0, 0},
                     {0, 0, 1, 0},
                     {0.5, 0.5, 0, 1}}};
          }},
      camera.projection);
  return product(world_to_camera(camera.frame), ndc_from_camera);
}

}  // namespace alhazen::render
