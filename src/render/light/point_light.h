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

  template <class L = Real>
  LightSample<L> sample(Vec3<L> point) const {
    const Vec3<L> to_light = Vec3<L>(position) - point;
    const L squared = length_squared(to_light);
    const L distance = square_root(squared);
    const Rgb<L> weight(intensity);
    return where_lit<L>(squared > L(0), {to_light / distance, distance,
                                         falloff == Falloff::none ? weight : weight / squared});
  }
};

}  // namespace alhazen::render
