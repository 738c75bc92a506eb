// render/light: all lights of a scene, rebased, and each of them as seen from a point.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "core/scene/light.h"
#include "render/light/directional_light.h"
#include "render/light/point_light.h"
#include "render/light/rectangle_light.h"
#include "render/light/sphere_light.h"
#include "render/light/spot_light.h"

namespace alhazen::render {

// One light as seen from one point: make it once per shaded point, then draw its samples.
template <class Real>
class LightView {
 public:
  // A light with one sample, known at once.
  explicit LightView(const LightSample<Real>& only) : view_(only) {}
  explicit LightView(const SphereLightView<Real>& view) : view_(view) {}
  explicit LightView(const RectangleLightView<Real>& view) : view_(view) {}

  // (u, v) in [0, 1)^2 choose the point on an area light; other lights do not look at them.
  LightSample<Real> sample(Real u, Real v) const {
    if (const auto* only = std::get_if<0>(&view_)) return *only;
    if (const auto* sphere = std::get_if<1>(&view_)) return sphere->sample(u, v);
    return std::get<2>(view_).sample(u, v);
  }

 private:
  std::variant<LightSample<Real>, SphereLightView<Real>, RectangleLightView<Real>> view_;
};

template <class Real>
class LightTable {
 public:
  LightTable() = default;
  // `rebased_origin`: the world position that is 0 in rebased coordinates. Differences are taken in
  // double before they are rounded to Real.
  LightTable(std::span<const Light> lights, Vec3d rebased_origin);

  // Lights with a direction to them, by LightId; an ambient light is counted but has no samples.
  std::size_t size() const { return kernels_.size(); }
  // Shadow rays per shaded point: 1 for lights without extent, 0 for ambient ones.
  int samples(LightId id) const;
  // `point` is rebased. Precondition: samples(id) > 0. The view must not outlive the table.
  LightView<Real> view(LightId id, Vec3<Real> point) const;

  // The sum of the ambient lights: adds albedo * radiance.
  Rgb<Real> ambient() const { return ambient_; }

 private:
  using Kernel =
      std::variant<PointLightKernel<Real>, DirectionalLightKernel<Real>, SpotLightKernel<Real>,
                   SphereLightKernel<Real>, RectangleLightKernel<Real>, std::monostate>;
  std::vector<Kernel> kernels_;
  Rgb<Real> ambient_{Real(0)};
};

}  // namespace alhazen::render
