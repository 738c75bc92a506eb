// render/wave: the lights that shine, one array a kind, with what the stages need besides the light
// itself.
#pragma once

#include <vector>

#include "core/base/overloaded.h"
#include "core/scene/live.h"
#include "render/light/directional_light.h"
#include "render/light/point_light.h"
#include "render/light/rectangle_light.h"
#include "render/light/sphere_light.h"
#include "render/light/spot_light.h"

namespace alhazen::render {

template <class Kernel>
struct PlacedLight {
  Kernel kernel;
  LightId id;  // among those that shine, so that one that does not changes no random number
  bool casts_shadows;
  ShapeId visible_shape;  // does not shadow its own light
};

template <class Real>
struct Lights {
  // lift(visible shape or kNoId, kernel): by what a rectangle is to be moved (shape/laid.h).
  template <class Lift>
  Lights(const std::vector<Light>& lights, Vec3d world_offset, const Lift& lift) {
    LightId next = 0;
    for (const Light& light : lights) {
      if (!shines(light)) continue;
      const LightId id = next++;
      const auto place = [&](auto& list, auto kernel) {
        list.push_back({kernel, id, light.casts_shadows, light.visible_shape});
      };
      std::visit(
          Overloaded{
              [&](const PointLight& l) { place(points, PointLightKernel<Real>(l, world_offset)); },
              [&](const DirectionalLight& l) {
                place(directionals, DirectionalLightKernel<Real>(l));
              },
              [&](const SpotLight& l) { place(spots, SpotLightKernel<Real>(l, world_offset)); },
              [&](const SphereLight& l) {
                place(spheres, SphereLightKernel<Real>(l, world_offset));
              },
              [&](const RectangleLight& l) {
                RectangleLightKernel<Real> kernel(l, world_offset);
                kernel.corner = kernel.corner + lift(light.visible_shape, kernel);
                place(rectangles, kernel);
              },
              [&](const AmbientLight& l) { ambient += Rgb<Real>(l.radiance); }},
          light.source);
    }
  }

  std::vector<PlacedLight<PointLightKernel<Real>>> points;
  std::vector<PlacedLight<DirectionalLightKernel<Real>>> directionals;
  std::vector<PlacedLight<SpotLightKernel<Real>>> spots;
  std::vector<PlacedLight<SphereLightKernel<Real>>> spheres;
  std::vector<PlacedLight<RectangleLightKernel<Real>>> rectangles;
  Rgb<Real> ambient;
};

}  // namespace alhazen::render
