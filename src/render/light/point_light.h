// render/light: light from a point, evenly in all directions.
#pragma once

#include "core/scene/light.h"
#include "render/light/light_sample.h"

namespace alhazen::render {

// Positions are rebased. A point exactly on the light is not lit: it has no direction to it.
template <class Real>
struct PointLightKernel {
  Vec3<Real> position;
  Rgb<Real> intensity;
  Falloff falloff = Falloff::inverse_square;

  PointLightKernel() = default;
  PointLightKernel(const PointLight& light, Vec3d rebased_origin)
      : position(light.position - rebased_origin),
        intensity(light.intensity),
        falloff(light.falloff) {}

  LightSample<Real> sample(Vec3<Real> point) const {
    const Vec3<Real> to_light = position - point;
    const Real squared = length_squared(to_light);
    if (!(squared > 0)) return {};
    const Real distance = square_root(squared);
    return {to_light / distance, distance,
            falloff == Falloff::none ? intensity : intensity / squared};
  }
};

}  // namespace alhazen::render
