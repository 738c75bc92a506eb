// render/light: a point light that shines into a cone with a soft edge.
#pragma once

#include "core/math/elementary.h"
#include "core/scene/light.h"
#include "render/light/point_light.h"

namespace alhazen::render {

// Between the two angles the share is (3 - 2 x) x^2 with x running from 0 to 1 in the cosine, as
// POV-Ray's spotlight does it; equal angles make a hard edge, lit on the edge itself.
template <class Real>
struct SpotLightKernel {
  PointLightKernel<Real> source;
  Vec3<Real> axis;
  Real cos_inner = 1, cos_outer = 1;

  SpotLightKernel() = default;
  SpotLightKernel(const SpotLight& light, Vec3d rebased_origin)
      : source({light.position, light.intensity, light.falloff}, rebased_origin),
        axis(light.axis),
        cos_inner(static_cast<Real>(cos_deg(light.inner_angle_deg))),
        cos_outer(static_cast<Real>(cos_deg(light.outer_angle_deg))) {}

  template <class L>
  L share(L cos_axis) const {
    const L inner(cos_inner), outer(cos_outer);
    const L x = (cos_axis - outer) / (inner - outer);
    const L inside = select(cos_axis <= outer, L(0), (3 - 2 * x) * x * x);
    return select(cos_axis >= inner, L(1), inside);
  }

  template <class L = Real>
  LightSample<L> sample(Vec3<L> point) const {
    LightSample<L> result = source.sample(point);
    result.weight = share(-dot(result.direction, Vec3<L>(axis))) * result.weight;
    return result;
  }
};

}  // namespace alhazen::render
