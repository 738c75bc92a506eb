// render/light: choosing points on a glowing parallelogram.
#include "render/light/rectangle_light.h"

#include <utility>

#include "core/math/elementary.h"

namespace alhazen::render {
namespace {

// Steradians. The angles that Urena's construction adds up carry an absolute error of some units of
// rounding, which is nothing to a solid angle above this.
template <class Real>
constexpr Real kSmallSolidAngle = Real(0.25);

// The solid angle of the rectangle from the foot of the perpendicular, at distance |z|, to the
// corner (x, y), in turns and with the sign of x y: atan(x y / (z sqrt(x^2 + y^2 + z^2))).
template <class Real>
Real corner_solid_angle_turns(Real x, Real y, Real z) {
  return atan2_turns(x * y, absolute(z) * length(Vec3<Real>(x, y, z)));
}

template <class Real>
Real clamped(Real x, Real low, Real high) {
  return smaller(larger(x, low), high);
}

}  // namespace

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

template <class Real>
RectangleLightView<Real>::RectangleLightView(const RectangleLightKernel<Real>& light,
                                             Vec3<Real> point)
    : light_(&light),
      to_corner_(light.corner - point),
      radiance_share_(light.radiance / static_cast<Real>(light.samples)) {
  z0_ = dot(to_corner_, light_->axis_n);
  lit_ = z0_ < 0;
  if (!lit_) return;
  // Area / depth^2 is more than the solid angle. Where that is small, all of the rectangle is seen
  // under nearly one angle and sampling its area loses nothing.
  const Real area = light_->length_u * light_->length_v;
  if (!light_->right_angled || area <= kSmallSolidAngle<Real> * z0_ * z0_) return;
  x0_ = dot(to_corner_, light_->axis_u);
  y0_ = dot(to_corner_, light_->axis_v);
  x1_ = x0_ + light_->length_u;
  y1_ = y0_ + light_->length_v;
  solid_angle_turns_ =
      larger(Real(0),
             corner_solid_angle_turns(x1_, y1_, z0_) - corner_solid_angle_turns(x0_, y1_, z0_) -
                 corner_solid_angle_turns(x1_, y0_, z0_) + corner_solid_angle_turns(x0_, y0_, z0_));
  solid_angle_ = 2 * pi<Real>() * solid_angle_turns_;
  spherical_ = solid_angle_ > kSmallSolidAngle<Real>;
  if (spherical_) prepare_spherical();
}

template <class Real>
void RectangleLightView<Real>::prepare_spherical() {
  // Normals of the planes through the point and the four edges; b are their depths.
  const auto depth = [this](Real side) {
    return side / square_root(fused_multiply_add(side, side, z0_ * z0_));
  };
  const Real bx0 = -depth(x0_), by0 = -depth(y0_), by1 = depth(y1_);
  // The edge planes of x and of y meet in angles whose cosine is the product of the depths.
  const Real g2 = acos_turns(clamped(-(by1 * bx0), Real(-1), Real(1)));
  const Real g3 = acos_turns(clamped(-(bx0 * by0), Real(-1), Real(1)));
  b0_ = by0;
  b1_ = by1;
  const Real c0 = z0_ / square_root(fused_multiply_add(y0_, y0_, z0_ * z0_));
  c0_squared_ = c0 * c0;
  k_turns_ = 1 - g2 - g3;
}

template <class Real>
LightSample<Real> RectangleLightView<Real>::spherical_sample(Real u, Real v) const {
  // 1. The x at which the part of the spherical rectangle to its left has the share u.
  const SinCos<Real> turn = sin_cos_of_turns(fused_multiply_add(u, solid_angle_turns_, k_turns_));
  const Real f = (turn.cos * b0_ - b1_) / turn.sin;
  // cos_u = sign(f) / sqrt(f^2 + b0^2), and x = -cos_u z0 / sqrt(1 - cos_u^2) with 1 - b0^2 = c0^2
  // put in, so that nothing cancels when the point is close to the plane of the light.
  const Real excess = f * f - c0_squared_;
  Real x = f > 0 ? x1_ : x0_;
  if (excess > 0) {
    const Real reach = -z0_ / square_root(excess);
    x = clamped(f > 0 ? reach : -reach, x0_, x1_);
  }
  // 2. On the arc at x the sine of the elevation is even in area.
  const Real d_squared = fused_multiply_add(x, x, z0_ * z0_);
  const Real h0 = y0_ / square_root(fused_multiply_add(y0_, y0_, d_squared));
  const Real h1 = y1_ / square_root(fused_multiply_add(y1_, y1_, d_squared));
  const Real h = fused_multiply_add(v, h1 - h0, h0);
  const Real rest = (1 - h) * (1 + h);
  Real y = h > 0 ? y1_ : y0_;
  if (rest > 0) y = clamped(h * square_root(d_squared / rest), y0_, y1_);

  const Vec3<Real> to_light =
      multiply_add(x, light_->axis_u, multiply_add(y, light_->axis_v, z0_ * light_->axis_n));
  const Real distance = length(to_light);
  return {to_light / distance, distance, solid_angle_ * radiance_share_};
}

template <class Real>
LightSample<Real> RectangleLightView<Real>::area_sample(Real u, Real v) const {
  const Vec3<Real> to_light =
      multiply_add(u, light_->edge_u, multiply_add(v, light_->edge_v, to_corner_));
  const Real distance = length(to_light);
  if (!(distance > 0)) return {};
  const Vec3<Real> direction = to_light / distance;
  const Real facing = larger(Real(0), -dot(direction, light_->area_normal));
  return {direction, distance, (facing / distance / distance) * radiance_share_};
}

template struct RectangleLightKernel<float>;
template struct RectangleLightKernel<double>;
template class RectangleLightView<float>;
template class RectangleLightView<double>;
#if ALHAZEN_HAS_QUAD
template struct RectangleLightKernel<Quad>;
template class RectangleLightView<Quad>;
#endif

}  // namespace alhazen::render
