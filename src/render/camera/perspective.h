// render/camera: the pinhole and thin-lens camera.
#pragma once

#include <type_traits>

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
  template <class L = Real>
  CameraRay<L> ray(const FilmPoint<L>& film, std::type_identity_t<L> lens_u,
                   std::type_identity_t<L> lens_v) const {
    const Vec3<L> to_right(right), to_top(up);
    const L from_left = static_cast<L>(film.column) + Real(0.5) - half_width;
    const L from_top = static_cast<L>(film.row) + Real(0.5) - half_height;
    const L x = (from_left + film.offset_x) * pixel_width;
    const L y = -((from_top + film.offset_y) * pixel_width);
    const Vec3<L> in_plane = multiply_add(x, to_right, multiply_add(y, to_top, Vec3<L>(forward)));
    if (!has_lens()) return {Vec3<L>(), normalized(in_plane)};
    const DiscPoint<L> disc = disc_from_square(lens_u, lens_v);
    const Vec3<L> on_lens = L(aperture_radius) * multiply_add(disc.x, to_right, disc.y * to_top);
    return {on_lens, normalized(multiply_add(L(focus_distance), in_plane, -on_lens))};
  }
};

}  // namespace alhazen::render
