// render/light: a glowing parallelogram that shines to one side.
//
// A rectangle that fills a good part of the sky is sampled evenly in solid angle (C. Urena,
// M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", EGSR 2013).
// Parallelograms, and rectangles below a quarter of a steradian, are sampled evenly in area with
// the exact Jacobian; for a small light the two hardly differ.
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

// The light as seen from one point: made once, sampled many times. The kernel must outlive it.
template <class Real>
class RectangleLightView {
 public:
  RectangleLightView(const RectangleLightKernel<Real>& light, Vec3<Real> point);

  // (u, v) in [0, 1)^2. Behind the light and in its plane the weight is black.
  LightSample<Real> sample(Real u, Real v) const {
    if (!lit_) return {};
    return spherical_ ? spherical_sample(u, v) : area_sample(u, v);
  }

 private:
  LightSample<Real> spherical_sample(Real u, Real v) const;
  LightSample<Real> area_sample(Real u, Real v) const;
  void prepare_spherical();

  const RectangleLightKernel<Real>* light_;
  Vec3<Real> to_corner_;
  Rgb<Real> radiance_share_;  // radiance / samples
  Real solid_angle_ = 0, solid_angle_turns_ = 0;
  bool lit_ = false, spherical_ = false;
  // Urena's names: the rectangle is [x0, x1] x [y0, y1] at depth z0 < 0 of the point.
  Real x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0, z0_ = 0;
  Real b0_ = 0, b1_ = 0, c0_squared_ = 0, k_turns_ = 0;
};

}  // namespace alhazen::render
