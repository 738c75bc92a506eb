// render/camera: the scene's camera, whichever it is.
#pragma once

#include <variant>

#include "core/scene/camera.h"
#include "render/camera/orthographic.h"
#include "render/camera/perspective.h"

namespace alhazen::render {

template <class Real>
class CameraKernel {
 public:
  CameraKernel() = default;
  // The picture's size in pixels.
  CameraKernel(const Camera& camera, int width, int height);

  // Whether rays look at the lens sample.
  bool has_lens() const {
    const auto* perspective = std::get_if<0>(&kernel_);
    return perspective != nullptr && perspective->has_lens();
  }
  // lens_u, lens_v in [0, 1).
  template <class L = Real>
  CameraRay<L> ray(const FilmPoint<L>& film, std::type_identity_t<L> lens_u,
                   std::type_identity_t<L> lens_v) const {
    if (const auto* perspective = std::get_if<0>(&kernel_))
      return perspective->ray(film, lens_u, lens_v);
    return std::get<1>(kernel_).ray(film);
  }

 private:
  std::variant<PerspectiveKernel<Real>, OrthographicKernel<Real>> kernel_;
};

}  // namespace alhazen::render
