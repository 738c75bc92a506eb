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

// What a point sees of the sphere: from outside a cone of directions around the centre; from
// inside, where the sphere glows too, all directions. Nothing but numbers, so that lanes can be
// dealt out (simd/records.h).
template <class Real>
struct SphereSight {
  Vec3<Real> axis;
  Tangents<Real> tangents;
  Real radius{}, distance{}, one_minus_cos{};
  Rgb<Real> weight;

  MaskOf<Real> is_inside() const { return distance < radius; }
};

// The light as seen from one point: made once, sampled many times.
template <class Real>
class SphereLightView {
 public:
  using Kernel = SphereLightKernel<ScalarOf<Real>>;

  SphereLightView(const Kernel& light, Vec3<Real> point) {
    const Vec3<Real> to_center = Vec3<Real>(light.center) - point;
    const Real radius(light.radius), distance = length(to_center);
    s_.radius = radius;
    s_.distance = distance;
    s_.axis =
        select(distance > Real(0), to_center / distance, Vec3<Real>(Real(0), Real(0), Real(1)));
    s_.tangents = tangents_of(s_.axis);
    // sin^2 and cos of the half angle from their factors, and 1 - cos = sin^2 / (1 + cos): exact to
    // rounding for a sphere that fills half of the sky and for one that is a speck.
    const Real sine = radius / distance;
    const Real cosine =
        square_root((distance - radius) / distance * ((distance + radius) / distance));
    s_.one_minus_cos = select(s_.is_inside(), Real(2), sine * (sine / (1 + cosine)));
    s_.weight = (2 * pi<Real>() * s_.one_minus_cos / static_cast<Real>(light.samples)) *
                Rgb<Real>(light.radiance);
  }
  // From a point that sees the light like this.
  static SphereLightView of(const Kernel&, const SphereSight<Real>& sight) {
    SphereLightView view;
    view.s_ = sight;
    return view;
  }

  const SphereSight<Real>& sight() const { return s_; }

  // (u, v) in [0, 1)^2: evenly in solid angle; the distance is that of the nearest point of the
  // sphere along the direction (from inside: the only one).
  LightSample<Real> sample(Real u, Real v) const {
    const Real below_pole = u * s_.one_minus_cos;  // 1 - cos of the angle with the axis
    const Real cosine = 1 - below_pole;
    const Real sine_squared = below_pole * (2 - below_pole);
    const Real sine = square_root(sine_squared);
    const SinCos<Real> turn = sin_cos_of_turns(v);
    const Vec3<Real> direction =
        multiply_add(cosine, s_.axis,
                     multiply_add(sine * turn.cos, s_.tangents.a, sine * turn.sin * s_.tangents.b));
    return {direction, distance_along(cosine, sine), s_.weight};
  }

 private:
  SphereLightView() = default;

  // The roots of t^2 - 2 d cos t + (d^2 - r^2) = 0, of product (d - r)(d + r).
  Real distance_along(Real cosine, Real sine) const {
    const Real middle = s_.distance * cosine;
    const Real off = s_.distance * sine;
    const Real half_chord = square_root(larger(Real(0), (s_.radius - off) * (s_.radius + off)));
    const Real product = (s_.distance - s_.radius) * (s_.distance + s_.radius);
    const Real sum = middle + half_chord;
    const MaskOf<Real> inside = s_.is_inside();
    const Real outside = select(sum > Real(0), product / sum, Real(0));
    if (!any(inside)) return outside;
    const Real within = select(middle >= Real(0), sum, product / (middle - half_chord));
    return select(inside, within, outside);
  }

  SphereSight<Real> s_;
};

}  // namespace alhazen::render
