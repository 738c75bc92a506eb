// render/light: parallel light from infinitely far away.
#pragma once

#include "core/scene/light.h"
#include "render/light/light_sample.h"

namespace alhazen::render {

template <class Real>
struct DirectionalLightKernel {
  Vec3<Real> to_light;
  Rgb<Real> irradiance;

  DirectionalLightKernel() = default;
  explicit DirectionalLightKernel(const DirectionalLight& light)
      : to_light(-light.direction), irradiance(light.irradiance) {}

  LightSample<Real> sample() const { return {to_light, infinity<Real>(), irradiance}; }
};

}  // namespace alhazen::render
