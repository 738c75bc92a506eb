// render/light: the numbers of a glowing parallelogram that shines to one side.
#pragma once

#include "core/scene/light.h"
#include "render/light/light_sample.h"

namespace alhazen::render {

template <class Real>
struct RectangleLightKernel {
  Vec3<Real> corner;  // rebased
  Vec3<Real> edge_u, edge_v;
  Vec3<Real> area_normal;  // cross(edge_u, edge_v): as long as the area, on the lit side
  Vec3<Real> axis_u, axis_v, axis_n;
  Real length_u = 1, length_v = 1;
  Rgb<Real> radiance;
  int samples = 1;
  bool right_angled = true;  // to the rounding of its edges

  RectangleLightKernel() = default;
  RectangleLightKernel(const RectangleLight& light, Vec3d rebased_origin);
};

}  // namespace alhazen::render
