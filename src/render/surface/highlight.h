// render/surface: glossy lobes that answer to lights only, normalised so that no more light leaves
// than `strength` says.
//
// Phong (E. Lafortune and Y. Willems, "Using the modified Phong reflectance model for physically
// based rendering", 1994):   f = strength (m + 2) / (2 pi) max(0, r.l)^m, r the mirrored view.
// Blinn, with h the half vector:  f = strength (m + 2)(m + 4) / (8 pi (m + 2^(-m/2))) (n.h)^m.
// Both are unchanged when view and light are exchanged. The factor before the power is the inverse
// of the integral of power times cosine over the hemisphere for a view along the normal (for Blinn:
// theta_l = 2 theta_h, and the integral of 8 pi u^(m+1) (2 u^2 - 1) du over [1/sqrt(2), 1]); at
// every other view the lobe holds less, so the directional albedo is at most `strength` (a test
// integrates it).
#pragma once

#include "core/math/elementary.h"
#include "core/math/vec.h"
#include "core/scene/material.h"

namespace alhazen::render {

// Nothing but numbers, so that lanes may each have a lobe of their own (simd/records.h).
template <class Real>
struct HighlightLobe {
  Real is_phong = 0;  // 1 for Phong's lobe, 0 for Blinn's
  Rgb<Real> scale;    // strength times normalisation
  Real exponent = 1;
};

template <class Real>
inline HighlightLobe<Real> make_highlight_lobe(const Highlight& highlight) {
  const double m = highlight.exponent;
  const bool is_phong = highlight.model == HighlightModel::phong;
  const double normalisation =
      is_phong ? (m + 2) / (2 * pi<double>())
               : (m + 2) / (8 * pi<double>()) * ((m + 4) / (m + power(2.0, -m / 2)));
  return {static_cast<Real>(is_phong ? 1 : 0), Rgb<Real>(normalisation * highlight.strength),
          static_cast<Real>(m)};
}

// The reflectance distribution, without the cosine at the light. All directions are of unit length
// and point away from the surface; `normal` is on the viewer's side. 0 unless both see the surface.
template <class Real>
inline Rgb<Real> highlight_value(const HighlightLobe<Real>& lobe, Vec3<Real> normal,
                                 Vec3<Real> to_view, Vec3<Real> to_light) {
  const Real cos_light = dot(normal, to_light), cos_view = dot(normal, to_view);
  const MaskOf<Real> both_see = cos_light > Real(0) && cos_view > Real(0);
  // r.l = 2 (n.v)(n.l) - v.l, symmetric to the bit.
  const Real cos_lobe =
      select(lobe.is_phong != Real(0), 2 * (cos_view * cos_light) - dot(to_view, to_light),
             dot(normal, normalized(to_view + to_light)));
  const MaskOf<Real> shines = both_see && cos_lobe > Real(0);
  if (!any(shines)) return Rgb<Real>();
  const Rgb<Real> value = power(smaller(cos_lobe, Real(1)), lobe.exponent) * lobe.scale;
  return select(shines, value, Rgb<Real>());
}

}  // namespace alhazen::render
