#include "app/cli/camera_matrices.h"

#include "core/base/overloaded.h"
#include "core/math/elementary.h"

namespace alhazen {
namespace {

using Matrix4 = std::array<std::array<double, 4>, 4>;

Matrix4 perspective_ndc(double tan_half_fov, double aspect) {
  const double scale = 0.5 / tan_half_fov;
  // The third row makes it invertible: 1 / z after division.
  return {{{scale, 0, 0.5, 0}, {0, -scale * aspect, 0.5, 0}, {0, 0, 0, 1}, {0, 0, 1, 0}}};
}

Matrix4 orthographic_ndc(double width, double aspect) {
  const double scale = 1 / width;
  return {{{scale, 0, 0, 0.5}, {0, -scale * aspect, 0, 0.5}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

}  // namespace

Affined camera_from_world(const CameraFrame& frame) {
  Affined map;
  const std::array<Vec3d, 3> axes = {frame.right, frame.up, frame.forward};
  for (std::size_t i = 0; i < 3; ++i) {
    map.rows[i] = {axes[i].x, axes[i].y, axes[i].z, -dot(axes[i], frame.position)};
  }
  return map;
}

Matrix4 ndc_from_world(const Camera& camera, const RenderSettings& settings) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const Matrix4 ndc = std::visit(
      Overloaded{[&](const PerspectiveCamera& c) {
                   return perspective_ndc(tan_deg(c.fov_deg / 2), aspect);
                 },
                 [&](const OrthographicCamera& c) { return orthographic_ndc(c.width, aspect); }},
      camera.projection);
  const Affined map = camera_from_world(camera.frame);
  Matrix4 product{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k)
        product[i][j] += ndc[i][k] * map.rows[k][j];
    }
    product[i][3] += ndc[i][3];
  }
  return product;
}

}  // namespace alhazen
