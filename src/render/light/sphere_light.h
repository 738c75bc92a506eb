// render/light: a glowing sphere, sampled evenly in the solid angle that it fills.
#pragma once

#include "core/math/elementary.h"
#include "core/scene/light.h"
#include "render/light/light_sample.h"

namespace alhazen::render {

template <class Real>
struct SphereLightKernel {
  Vec3<Real> center;  // rebased
  Real radius = 1;
  Rgb<Real> radiance;
  int samples = 1;

  SphereLightKernel() = default;
  SphereLightKernel(const SphereLight& light, Vec3d rebased_origin)
      : center(light.center - rebased_origin),
        radius(static_cast<Real>(light.radius)),
        radiance(light.radiance),
        samples(light.samples) {}
};

// The light as seen from one point: made once, sampled many times. From outside it is a cone of
// directions around the centre; from inside, where the sphere glows too, all directions.
template <class Real>
class SphereLightView {
 public:
  SphereLightView(const SphereLightKernel<Real>& light, Vec3<Real> point) : radius_(light.radius) {
    const Vec3<Real> to_center = light.center - point;
    distance_ = length(to_center);
    inside_ = distance_ < radius_;
    axis_ = distance_ > 0 ? to_center / distance_ : Vec3<Real>(Real(0), Real(0), Real(1));
    tangents_ = tangents_of(axis_);
    // sin^2 and cos of the half angle from their factors, and 1 - cos = sin^2 / (1 + cos): exact to
    // rounding for a sphere that fills half of the sky and for one that is a speck.
    one_minus_cos_ = 2;
    if (!inside_) {
      const Real sine = radius_ / distance_;
      const Real cosine =
          square_root((distance_ - radius_) / distance_ * ((distance_ + radius_) / distance_));
      one_minus_cos_ = sine * (sine / (1 + cosine));
    }
    weight_ = (2 * pi<Real>() * one_minus_cos_ / static_cast<Real>(light.samples)) * light.radiance;
  }

  // (u, v) in [0, 1)^2: evenly in solid angle; the distance is that of the nearest point of the
  // sphere along the direction (from inside: the only one).
  LightSample<Real> sample(Real u, Real v) const {
    const Real below_pole = u * one_minus_cos_;  // 1 - cos of the angle with the axis
    const Real cosine = 1 - below_pole;
    const Real sine_squared = below_pole * (2 - below_pole);
    const Real sine = square_root(sine_squared);
    const SinCos<Real> turn = sin_cos_of_turns(v);
    const Vec3<Real> direction = multiply_add(
        cosine, axis_, multiply_add(sine * turn.cos, tangents_.a, sine * turn.sin * tangents_.b));
    return {direction, distance_along(cosine, sine), weight_};
  }

 private:
  // The roots of t^2 - 2 d cos t + (d^2 - r^2) = 0, of product (d - r)(d + r).
  Real distance_along(Real cosine, Real sine) const {
    const Real middle = distance_ * cosine;
    const Real off = distance_ * sine;
    const Real half_chord = square_root(larger(Real(0), (radius_ - off) * (radius_ + off)));
    if (inside_ && middle >= 0) return middle + half_chord;
    const Real product = (distance_ - radius_) * (distance_ + radius_);
    if (inside_) return product / (middle - half_chord);
    const Real sum = middle + half_chord;
    return sum > 0 ? product / sum : Real(0);
  }

  Vec3<Real> axis_;
  Tangents<Real> tangents_;
  Real radius_, distance_, one_minus_cos_;
  Rgb<Real> weight_;
  bool inside_;
};

}  // namespace alhazen::render
