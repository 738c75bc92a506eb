// render/camera: the camera whose rays are parallel.
#pragma once

#include "core/scene/camera.h"
#include "render/camera/camera_ray.h"

namespace alhazen::render {

// The picture is `width` world lengths wide, its centre at the camera's position; pixels are
// square.
template <class Real>
struct OrthographicKernel {
  Vec3<Real> right, up, forward;
  Real half_width = 1, half_height = 1;  // of the picture in pixels; whole or half numbers
  Real pixel_width = 1;                  // in world lengths

  OrthographicKernel() = default;
  OrthographicKernel(const CameraFrame& frame, const OrthographicCamera& camera, int width,
                     int height);

  template <class L = Real>
  CameraRay<L> ray(const FilmPoint<L>& film) const {
    const L from_left = static_cast<L>(film.column) + Real(0.5) - half_width;
    const L from_top = static_cast<L>(film.row) + Real(0.5) - half_height;
    const L x = (from_left + film.offset_x) * pixel_width;
    const L y = -((from_top + film.offset_y) * pixel_width);
    return {multiply_add(x, Vec3<L>(right), y * Vec3<L>(up)), Vec3<L>(forward)};
  }
};

}  // namespace alhazen::render
