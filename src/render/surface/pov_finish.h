// render/surface: POV-Ray 3.7's surface model (docs/pov_ray.md). It answers to lights by formulas
// of its own: nothing is divided by pi, and more light may leave than came.
#pragma once

#include "core/math/elementary.h"
#include "core/math/vec.h"
#include "core/scene/material.h"

namespace alhazen::render {

// What a finish is made of, in parts that are asked for at different places. Nothing but numbers,
// so that lanes may each have a finish of their own (simd/records.h). What is asked is answered by
// 1 for yes and 0 for no.

// How it answers to light.
template <class Real>
struct PovShading {
  Real diffuse = 0;  // times opacity
  Real brilliance = 1;
  Real phong = 0, phong_size = 40, specular = 0, specular_exponent = 20;
  Real metallic = 0;
};

template <class Real>
struct PovMirror {
  Rgb<Real> min, max;
  Real falloff = 1, metallic = 0;
  Real fresnel = 0, conserves_energy = 0;
};

// What passes the surface, and whether it fades inside.
template <class Real>
struct PovPassage {
  Real filter = 0, transmit = 0;
  Real fades = 0;
};

template <class Real>
struct PovFading {
  Real distance = 0, power = 0;
  Rgb<Real> color;
};

template <class Real>
struct PovSurface {
  Rgb<Real> glow;  // ambient + emission, times opacity
  PovShading<Real> shading;
  PovMirror<Real> mirror;
  PovPassage<Real> passage;
  PovFading<Real> fading;
};

template <class Real>
inline PovSurface<Real> make_pov_surface(const PovFinish& m) {
  const auto number = [](double x) { return static_cast<Real>(x); };
  const auto answer = [](bool yes) { return static_cast<Real>(yes ? 1 : 0); };
  PovSurface<Real> s;
  s.glow = Rgb<Real>(opacity(m) * (m.ambient + m.emission));
  s.shading = {number(opacity(m) * m.diffuse),
               number(m.brilliance),
               number(m.phong),
               number(m.phong_size),
               number(m.specular),
               number(1 / m.roughness),
               number(m.metallic)};
  s.mirror = {Rgb<Real>(m.reflection.min),  Rgb<Real>(m.reflection.max),
              number(m.reflection.falloff), number(m.reflection.metallic),
              answer(m.reflection.fresnel), answer(m.conserve_energy)};
  s.passage = {number(m.filter), number(m.transmit), answer(fades(m))};
  s.fading = {number(m.fade_distance), number(m.fade_power), Rgb<Real>(m.fade_color)};
  return s;
}

// The tint of highlights and reflections by the surface's colour, which goes away towards grazing
// angles: POV-Ray's fit to Fresnel's equations, of x = the angle over a right angle.
template <class Real>
inline Rgb<Real> pov_metal_tint(Real metallic, Rgb<Real> color, Real cosine) {
  const MaskOf<Real> is_metallic = metallic != Real(0);
  if (!any(is_metallic)) return Rgb<Real>(Real(1));
  const Real x = 4 * acos_turns(smaller(cosine, Real(1)));
  const Real below = x - Real(1.12);
  const Real fit = Real(0.014567225) / (below * below) - Real(0.011612903);
  const Real share = metallic * (1 - larger(Real(0), smaller(Real(1), fit)));
  return select(is_metallic, Rgb<Real>(Real(1)) + share * (color - Rgb<Real>(Real(1))),
                Rgb<Real>(Real(1)));
}

// What both highlights add to light 1. All directions are of unit length and point away from the
// surface, `normal` on the viewer's side and the light's.
template <class Real>
inline Rgb<Real> pov_highlights(const PovShading<Real>& s, Rgb<Real> color, Vec3<Real> normal,
                                Vec3<Real> to_view, Vec3<Real> to_light) {
  const Real cos_light = dot(normal, to_light);
  Real sum = 0;
  const auto add = [&sum](MaskOf<Real> shines, Real strength, Real along, Real exponent) {
    if (!any(shines)) return;
    const Real lobe = strength * power(smaller(along, Real(1)), exponent);
    sum = select(shines, sum + lobe, sum);
  };
  const MaskOf<Real> has_phong = s.phong != Real(0), has_specular = s.specular != Real(0);
  if (any(has_phong)) {
    const Real along = 2 * (dot(normal, to_view) * cos_light) - dot(to_view, to_light);
    // POV-Ray leaves out what a sharp highlight would be far from its middle.
    const MaskOf<Real> is_far = s.phong_size >= Real(60) && along <= Real(0.0008);
    add(has_phong && along > Real(0) && !is_far, s.phong, along, s.phong_size);
  }
  if (any(has_specular)) {
    const Real along = dot(normal, normalized(to_view + to_light));
    add(has_specular && along > Real(0), s.specular, along, s.specular_exponent);
  }
  const MaskOf<Real> shines = sum != Real(0);
  if (!any(shines)) return Rgb<Real>();
  return select(shines, sum * pov_metal_tint(s.metallic, color, cos_light), Rgb<Real>());
}

// power(base, exponent), which is not asked where the exponent is 1.
template <class Real>
inline Real power_unless_one(Real base, Real exponent) {
  const MaskOf<Real> bends = exponent != Real(1);
  return any(bends) ? select(bends, power(base, exponent), base) : base;
}

// What the matt part adds to light 1 at the cosine > 0: the cosine is part of it.
template <class Real>
inline Rgb<Real> pov_diffuse(const PovShading<Real>& s, Rgb<Real> color, Real cosine) {
  return (s.diffuse * power_unless_one(cosine, s.brilliance)) * color;
}

// The reflectance for a view at `cosine` in [0, 1]; `fresnel` is Fresnel's at that angle, asked for
// by `s.fresnel` only.
template <class Real>
inline Rgb<Real> pov_reflectance(const PovMirror<Real>& s, Rgb<Real> color, Real cosine,
                                 Real fresnel) {
  const MaskOf<Real> by_fresnel = s.fresnel != Real(0);
  const Real by_angle = all(by_fresnel) ? Real(0) : power_unless_one(1 - cosine, s.falloff);
  const Real k = select(by_fresnel, fresnel, by_angle);
  return (s.min + k * (s.max - s.min)) * pov_metal_tint(s.metallic, color, cosine);
}

// What `conserve_energy` leaves for what passes.
template <class Real>
inline Rgb<Real> pov_rest(Rgb<Real> reflectance) {
  const auto rest = [](Real r) { return larger(Real(0), 1 - r); };
  return {rest(reflectance.r), rest(reflectance.g), rest(reflectance.b)};
}

// What a surface lets through, whatever the angle.
template <class Real>
inline Rgb<Real> pov_passed(const PovPassage<Real>& s, Rgb<Real> color) {
  return s.filter * color + Rgb<Real>(s.transmit);
}

// What is left after `distance` inside.
template <class Real>
inline Rgb<Real> pov_fade(const PovFading<Real>& s, Real distance) {
  const Real depth = distance / s.distance;
  const MaskOf<Real> is_exponential = s.power >= Real(1000);
  const Real half_life = all(is_exponential) ? Real(0) : 1 + power(depth, s.power);
  const auto channel = [&](Real c) {
    const MaskOf<Real> is_lossless = c == Real(1);
    Real left = c + (1 - c) / half_life;
    if (any(is_exponential && !is_lossless))
      left = select(is_exponential, exp_of((c - 1) * depth), left);
    return select(is_lossless, Real(1), left);
  };
  return {channel(s.color.r), channel(s.color.g), channel(s.color.b)};
}

}  // namespace alhazen::render
