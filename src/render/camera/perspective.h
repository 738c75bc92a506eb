// render/camera: the pinhole and thin-lens camera.
#pragma once

#include "core/scene/camera.h"
#include "render/camera/camera_ray.h"
#include "render/camera/disc.h"

namespace alhazen::render {

// As POV-Ray: fov is the full horizontal angle, pixels are square, the ray through a pixel's centre
// goes to ((column + 1/2) - width/2, height/2 - (row + 1/2)) times the pixel's width in the plane
// at distance 1.
template <class Real>
struct PerspectiveKernel {
  Vec3<Real> right, up, forward;
  Real half_width = 1, half_height = 1;  // of the picture in pixels; whole or half numbers
  Real pixel_width = 1;                  // in the plane at distance 1: 2 tan(fov/2) / width
  Real aperture_radius = 0, focus_distance = 1;

  PerspectiveKernel() = default;
  PerspectiveKernel(const CameraFrame& frame, const PerspectiveCamera& camera, int width,
                    int height);

  bool has_lens() const { return aperture_radius > 0; }

  // lens_u, lens_v in [0, 1) choose the point of the lens; a pinhole does not look at them. With a
  // lens all rays of one film point meet in the plane at focus_distance, where the picture is
  // sharp.
  CameraRay<Real> ray(const FilmPoint<Real>& film, Real lens_u, Real lens_v) const {
    const Real from_left = static_cast<Real>(film.column) + Real(0.5) - half_width;
    const Real from_top = static_cast<Real>(film.row) + Real(0.5) - half_height;
    const Real x = (from_left + film.offset_x) * pixel_width;
    const Real y = -((from_top + film.offset_y) * pixel_width);
    const Vec3<Real> in_plane = multiply_add(x, right, multiply_add(y, up, forward));
    if (!has_lens()) return {Vec3<Real>(), normalized(in_plane)};
    const DiscPoint<Real> disc = disc_from_square(lens_u, lens_v);
    const Vec3<Real> on_lens = aperture_radius * multiply_add(disc.x, right, disc.y * up);
    return {on_lens, normalized(multiply_add(focus_distance, in_plane, -on_lens))};
  }
};

}  // namespace alhazen::render
