// render/light: a glowing parallelogram that shines to one side, and choosing points on it.
//
// A rectangle that fills a good part of the sky is sampled evenly in solid angle (C. Urena,
// M. Fajardo, A. King, "An Area-Preserving Parametrization for Spherical Rectangles", EGSR 2013).
// Parallelograms, and rectangles below a quarter of a steradian, are sampled evenly in area with
// the exact Jacobian; for a small light the two hardly differ.
#pragma once

#include "core/math/elementary.h"
#include "render/light/rectangle_kernel.h"

namespace alhazen::render {

// Steradians. The angles that Urena's construction adds up carry an absolute error of some units of
// rounding, which is nothing to a solid angle above this.
inline constexpr double kSmallSolidAngle = 0.25;

// What the point sees of the rectangle; nothing but numbers, so that lanes can be dealt
// out (simd/records.h). Urena's names: the rectangle is [x0, x1] x [y0, y1] at depth z0 of the
// point, which the light shines on if z0 < 0. Where it is certainly small, `solid_angle` is 0 and
// nothing else is looked at.
template <class Real>
struct RectangleSight {
  Vec3<Real> to_corner;
  Real z0{}, solid_angle{}, solid_angle_turns{}, x0{}, x1{}, y0{}, y1{};
  Real b0{}, b1{}, c0_squared{}, k_turns{};

  MaskOf<Real> is_lit() const { return z0 < Real(0); }
  MaskOf<Real> is_spherical() const { return solid_angle > Real(kSmallSolidAngle); }
};

// The solid angle of the rectangle from the foot of the perpendicular, at distance |z|, to the
// corner (x, y), in turns and with the sign of x y: atan(x y / (z sqrt(x^2 + y^2 + z^2))).
template <class Real>
inline Real corner_solid_angle_turns(Real x, Real y, Real z) {
  return atan2_turns(x * y, absolute(z) * length(Vec3<Real>(x, y, z)));
}

template <class Real>
inline Real clamped(Real x, Real low, Real high) {
  return smaller(larger(x, low), high);
}

// The light as seen from one point: made once, sampled many times. The kernel must outlive it.
template <class Real>
class RectangleLightView {
 public:
  using Kernel = RectangleLightKernel<ScalarOf<Real>>;

  RectangleLightView(const Kernel& light, Vec3<Real> point);
  // From a point that sees the light like this.
  static RectangleLightView of(const Kernel& light, const RectangleSight<Real>& sight) {
    RectangleLightView view;
    view.light_ = &light;
    view.sight_ = sight;
    return view;
  }

  const RectangleSight<Real>& sight() const { return sight_; }

  // (u, v) in [0, 1)^2. Behind the light and in its plane the weight is black.
  LightSample<Real> sample(Real u, Real v) const {
    const MaskOf<Real> spherical = sight_.is_spherical(), lit = sight_.is_lit();
    if (!any(lit)) return {};
    if (!any(spherical)) return where_lit(lit, area_sample(u, v));
    const LightSample<Real> a = spherical_sample(u, v);
    if (all(spherical || !lit)) return where_lit(lit, a);
    const LightSample<Real> b = area_sample(u, v);
    return where_lit<Real>(
        lit, {select(spherical, a.direction, b.direction),
              select(spherical, a.distance, b.distance), select(spherical, a.weight, b.weight)});
  }

 private:
  RectangleLightView() = default;
  LightSample<Real> spherical_sample(Real u, Real v) const;
  LightSample<Real> area_sample(Real u, Real v) const;
  void measure_solid_angle();
  void prepare_spherical();
  Rgb<Real> radiance_share() const {
    return Rgb<Real>(light_->radiance / static_cast<ScalarOf<Real>>(light_->samples));
  }

  const Kernel* light_ = nullptr;
  RectangleSight<Real> sight_;
};

template <class Real>
RectangleLightView<Real>::RectangleLightView(const Kernel& light, Vec3<Real> point)
    : light_(&light) {
  sight_.to_corner = Vec3<Real>(light.corner) - point;
  sight_.z0 = dot(sight_.to_corner, Vec3<Real>(light.axis_n));
  // Area / depth^2 is more than the solid angle. Where that is small, all of the rectangle is seen
  // under nearly one angle and sampling its area loses nothing.
  const Real area(light.length_u * light.length_v);
  const MaskOf<Real> may_be_large =
      sight_.is_lit() && !(area <= Real(kSmallSolidAngle) * sight_.z0 * sight_.z0);
  if (!light.right_angled || !any(may_be_large)) return;
  measure_solid_angle();
  sight_.solid_angle = select(may_be_large, sight_.solid_angle, Real(0));
  if (any(sight_.is_spherical())) prepare_spherical();
}

template <class Real>
void RectangleLightView<Real>::measure_solid_angle() {
  RectangleSight<Real>& s = sight_;
  s.x0 = dot(s.to_corner, Vec3<Real>(light_->axis_u));
  s.y0 = dot(s.to_corner, Vec3<Real>(light_->axis_v));
  s.x1 = s.x0 + light_->length_u;
  s.y1 = s.y0 + light_->length_v;
  const auto corner = [&s](Real x, Real y) { return corner_solid_angle_turns(x, y, s.z0); };
  s.solid_angle_turns = larger(
      Real(0), corner(s.x1, s.y1) - corner(s.x0, s.y1) - corner(s.x1, s.y0) + corner(s.x0, s.y0));
  s.solid_angle = 2 * pi<Real>() * s.solid_angle_turns;
}

template <class Real>
void RectangleLightView<Real>::prepare_spherical() {
  RectangleSight<Real>& s = sight_;
  // Normals of the planes through the point and the four edges; b are their depths.
  const auto depth = [&s](Real side) {
    return side / square_root(fused_multiply_add(side, side, s.z0 * s.z0));
  };
  const Real bx0 = -depth(s.x0), by0 = -depth(s.y0), by1 = depth(s.y1);
  // The edge planes of x and of y meet in angles whose cosine is the product of the depths.
  const Real g2 = acos_turns(clamped(-(by1 * bx0), Real(-1), Real(1)));
  const Real g3 = acos_turns(clamped(-(bx0 * by0), Real(-1), Real(1)));
  s.b0 = by0;
  s.b1 = by1;
  const Real c0 = s.z0 / square_root(fused_multiply_add(s.y0, s.y0, s.z0 * s.z0));
  s.c0_squared = c0 * c0;
  s.k_turns = 1 - g2 - g3;
}

template <class Real>
LightSample<Real> RectangleLightView<Real>::spherical_sample(Real u, Real v) const {
  const RectangleSight<Real>& s = sight_;
  // 1. The x at which the part of the spherical rectangle to its left has the share u.
  const SinCos<Real> turn = sin_cos_of_turns(fused_multiply_add(u, s.solid_angle_turns, s.k_turns));
  const Real f = (turn.cos * s.b0 - s.b1) / turn.sin;
  // cos_u = sign(f) / sqrt(f^2 + b0^2), and x = -cos_u z0 / sqrt(1 - cos_u^2) with 1 - b0^2 = c0^2
  // put in, so that nothing cancels when the point is close to the plane of the light.
  const Real excess = f * f - s.c0_squared;
  const Real reach = -s.z0 / square_root(excess);
  const MaskOf<Real> right = f > Real(0);
  const Real x = select(excess > Real(0), clamped(select(right, reach, -reach), s.x0, s.x1),
                        select(right, s.x1, s.x0));
  // 2. On the arc at x the sine of the elevation is even in area.
  const Real d_squared = fused_multiply_add(x, x, s.z0 * s.z0);
  const Real h0 = s.y0 / square_root(fused_multiply_add(s.y0, s.y0, d_squared));
  const Real h1 = s.y1 / square_root(fused_multiply_add(s.y1, s.y1, d_squared));
  const Real h = fused_multiply_add(v, h1 - h0, h0);
  const Real rest = (1 - h) * (1 + h);
  const Real y = select(rest > Real(0), clamped(h * square_root(d_squared / rest), s.y0, s.y1),
                        select(h > Real(0), s.y1, s.y0));

  const Vec3<Real> axis_u(light_->axis_u), axis_v(light_->axis_v), axis_n(light_->axis_n);
  const Vec3<Real> to_light = multiply_add(x, axis_u, multiply_add(y, axis_v, s.z0 * axis_n));
  const Real distance = length(to_light);
  return {to_light / distance, distance, s.solid_angle * radiance_share()};
}

template <class Real>
LightSample<Real> RectangleLightView<Real>::area_sample(Real u, Real v) const {
  const Vec3<Real> edge_u(light_->edge_u), edge_v(light_->edge_v), normal(light_->area_normal);
  const Vec3<Real> to_light = multiply_add(u, edge_u, multiply_add(v, edge_v, sight_.to_corner));
  const Real distance = length(to_light);
  const Vec3<Real> direction = to_light / distance;
  const Real facing = larger(Real(0), -dot(direction, normal));
  return where_lit<Real>(distance > Real(0),
                         {direction, distance, (facing / distance / distance) * radiance_share()});
}

}  // namespace alhazen::render
