// render/light: the numbers of a glowing parallelogram.
#include "render/light/rectangle_kernel.h"

namespace alhazen::render {

template <class Real>
RectangleLightKernel<Real>::RectangleLightKernel(const RectangleLight& light, Vec3d rebased_origin)
    : corner(light.corner - rebased_origin),
      edge_u(light.edge_u),
      edge_v(light.edge_v),
      area_normal(cross(edge_u, edge_v)),
      axis_u(normalized(edge_u)),
      axis_v(normalized(edge_v)),
      axis_n(normalized(area_normal)),
      length_u(length(edge_u)),
      length_v(length(edge_v)),
      radiance(light.radiance),
      samples(light.samples) {
  // Edges that were rotated by a scene transform are orthogonal to a few units of double's
  // rounding.
  const double skew = dot(normalized(light.edge_u), normalized(light.edge_v));
  right_angled = absolute(skew) <= 16 * ScalarTraits<double>::unit_roundoff();
}

template struct RectangleLightKernel<float>;
template struct RectangleLightKernel<double>;
#if ALHAZEN_HAS_QUAD
template struct RectangleLightKernel<Quad>;
#endif

}  // namespace alhazen::render
