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

  CameraRay<Real> ray(const FilmPoint<Real>& film) const {
    const Real from_left = static_cast<Real>(film.column) + Real(0.5) - half_width;
    const Real from_top = static_cast<Real>(film.row) + Real(0.5) - half_height;
    const Real x = (from_left + film.offset_x) * pixel_width;
    const Real y = -((from_top + film.offset_y) * pixel_width);
    return {multiply_add(x, right, y * up), forward};
  }
};

}  // namespace alhazen::render
