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

  template <class L = Real>
  LightSample<L> sample() const {
    return {Vec3<L>(to_light), infinity<L>(), Rgb<L>(irradiance)};
  }
};

}  // namespace alhazen::render
