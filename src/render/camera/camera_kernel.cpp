// render/camera: from the scene's camera to the numbers that rays are made of.
#include "render/camera/camera_kernel.h"

#include "core/math/elementary.h"

namespace alhazen::render {

// The constants are computed in double and rounded once, so that all precisions see one camera.
template <class Real>
PerspectiveKernel<Real>::PerspectiveKernel(const CameraFrame& frame,
                                           const PerspectiveCamera& camera, int width, int height)
    : right(frame.right),
      up(frame.up),
      forward(frame.forward),
      half_width(static_cast<Real>(width) / 2),
      half_height(static_cast<Real>(height) / 2),
      pixel_width(static_cast<Real>(2 * tan_deg(camera.fov_deg / 2) / width)) {
  if (!camera.lens) return;
  aperture_radius = static_cast<Real>(camera.lens->aperture_radius);
  focus_distance = static_cast<Real>(camera.lens->focus_distance);
}

template <class Real>
OrthographicKernel<Real>::OrthographicKernel(const CameraFrame& frame,
                                             const OrthographicCamera& camera, int width,
                                             int height)
    : right(frame.right),
      up(frame.up),
      forward(frame.forward),
      half_width(static_cast<Real>(width) / 2),
      half_height(static_cast<Real>(height) / 2),
      pixel_width(static_cast<Real>(camera.width / width)) {}

template <class Real>
CameraKernel<Real>::CameraKernel(const Camera& camera, int width, int height) {
  if (const auto* perspective = std::get_if<PerspectiveCamera>(&camera.projection)) {
    kernel_ = PerspectiveKernel<Real>(camera.frame, *perspective, width, height);
  } else {
    kernel_ = OrthographicKernel<Real>(
        camera.frame, std::get<OrthographicCamera>(camera.projection), width, height);
  }
}

template class CameraKernel<float>;
template class CameraKernel<double>;
#if ALHAZEN_HAS_QUAD
template class CameraKernel<Quad>;
#endif

}  // namespace alhazen::render
