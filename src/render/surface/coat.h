// render/surface: a clear smooth dielectric layer over a diffuse base, as varnish over wood.
//
// The layer reflects F(i) as a mirror. What enters, 1 - F(i), is refracted, meets the base, leaves
// it diffusely, and is partly reflected back by the inside of the surface, again and again. The sum
// of that geometric series, for a base of albedo rho and a relative index n, is
//   f(i, o) = T(i) T(o) A(i) A(o) / n^2  *  rho / (pi (1 - rho K)),
// with T = 1 - F, A = exp(-tau / cos') one passage of the layer along the refracted direction, and
// K the share of diffuse light that comes back to the base after one internal reflection,
//   K = 2 integral of F_internal(mu) exp(-2 tau / mu) mu dmu,   K = 1 - (1 - F_e) / n^2 for tau =
//   0.
// The factor 1/n^2 is the widening of solid angle on leaving. A white base under a clear layer
// gives back all: the integral of f(i, o) cos_o is T(i) (1 - F_e) / n^2 / (1 - K) = T(i).
#pragma once

#include "core/math/elementary.h"
#include "core/math/vec.h"
#include "core/scene/material.h"
#include "render/surface/fresnel.h"

namespace alhazen::render {

template <class Real>
struct CoatLayer {
  Real eta = 1;              // 1 / n: from the air into the layer
  Rgb<Real> optical_depth;   // tau
  Rgb<Real> internal;        // K
  Rgb<Real> diffuse_escape;  // 2/n^2 integral of T(mu) exp(-tau / mu') mu dmu: out of the layer
};

// Integrates K and the escape once per material, to 1e-14.
template <class Real>
CoatLayer<Real> make_coat_layer(const Coat& coat);

// The share of light mirrored by the top of the layer, cos of the view in [0, 1].
template <class Real>
inline Real coat_mirror_reflectance(const CoatLayer<Real>& layer, Real cosine) {
  return dielectric_interface(cosine, layer.eta).reflectance;
}

// T A: what passes the layer once along one direction.
template <class Real>
inline Rgb<Real> coat_passage(const CoatLayer<Real>& layer, Real cosine) {
  const DielectricInterface<Real> top = dielectric_interface(cosine, layer.eta);
  const Rgb<Real> tau = layer.optical_depth;
  const MaskOf<Real> is_clear = is_black(tau);
  if (all(is_clear)) return Rgb<Real>(top.transmittance);
  const Real c = top.cos_transmitted;
  const Rgb<Real> share(exp_of(-tau.r / c), exp_of(-tau.g / c), exp_of(-tau.b / c));
  return select(is_clear, Rgb<Real>(top.transmittance), top.transmittance * share);
}

// rho / (1 - rho K), channel by channel.
template <class Real>
inline Rgb<Real> coat_base_series(const CoatLayer<Real>& layer, Rgb<Real> base_albedo) {
  const auto channel = [](Real rho, Real k) { return rho / fused_multiply_add(-rho, k, Real(1)); };
  return {channel(base_albedo.r, layer.internal.r), channel(base_albedo.g, layer.internal.g),
          channel(base_albedo.b, layer.internal.b)};
}

// f(i, o): the reflectance distribution of the base seen through the layer, without the cosine at
// the light. Both cosines in (0, 1].
template <class Real>
inline Rgb<Real> coat_diffuse_value(const CoatLayer<Real>& layer, Rgb<Real> base_albedo,
                                    Real cos_view, Real cos_light) {
  const Real solid_angle = layer.eta * layer.eta / pi<Real>();
  return solid_angle * (coat_passage(layer, cos_view) * coat_passage(layer, cos_light) *
                        coat_base_series(layer, base_albedo));
}

// The integral of f cos over the hemisphere: what an even sky of radiance 1 adds, besides its
// mirror image.
template <class Real>
inline Rgb<Real> coat_diffuse_albedo(const CoatLayer<Real>& layer, Rgb<Real> base_albedo,
                                     Real cos_view) {
  return coat_passage(layer, cos_view) * layer.diffuse_escape *
         coat_base_series(layer, base_albedo);
}

}  // namespace alhazen::render
