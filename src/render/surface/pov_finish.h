// render/surface: POV-Ray 3.7's surface model (docs/pov_ray.md). It answers to lights by formulas
// of its own: nothing is divided by pi, and more light may leave than came.
#pragma once

#include "core/math/elementary.h"
#include "core/math/vec.h"
#include "core/scene/material.h"

namespace alhazen::render {

template <class Real>
struct PovSurface {
  Real filter = 0, transmit = 0, opacity = 1;
  Rgb<Real> glow;    // ambient + emission, times opacity
  Real diffuse = 0;  // times opacity
  Real brilliance = 1;
  Real phong = 0, phong_size = 40, specular = 0, specular_exponent = 20;
  Real metallic = 0;
  Rgb<Real> reflect_min, reflect_max;
  Real reflect_falloff = 1, reflect_metallic = 0;
  bool fresnel = false;
  bool conserves_energy = false;
  bool fades = false;
  Real fade_distance = 0, fade_power = 0;
  Rgb<Real> fade_color;
};

template <class Real>
inline PovSurface<Real> make_pov_surface(const PovFinish& m) {
  PovSurface<Real> s;
  s.filter = static_cast<Real>(m.filter);
  s.transmit = static_cast<Real>(m.transmit);
  s.opacity = static_cast<Real>(opacity(m));
  s.glow = Rgb<Real>(opacity(m) * (m.ambient + m.emission));
  s.diffuse = static_cast<Real>(opacity(m) * m.diffuse);
  s.brilliance = static_cast<Real>(m.brilliance);
  s.phong = static_cast<Real>(m.phong);
  s.phong_size = static_cast<Real>(m.phong_size);
  s.specular = static_cast<Real>(m.specular);
  s.specular_exponent = static_cast<Real>(1 / m.roughness);
  s.metallic = static_cast<Real>(m.metallic);
  s.reflect_min = Rgb<Real>(m.reflection.min);
  s.reflect_max = Rgb<Real>(m.reflection.max);
  s.reflect_falloff = static_cast<Real>(m.reflection.falloff);
  s.reflect_metallic = static_cast<Real>(m.reflection.metallic);
  s.fresnel = m.reflection.fresnel;
  s.conserves_energy = m.conserve_energy;
  s.fades = fades(m);
  s.fade_distance = static_cast<Real>(m.fade_distance);
  s.fade_power = static_cast<Real>(m.fade_power);
  s.fade_color = Rgb<Real>(m.fade_color);
  return s;
}

// The tint of highlights and reflections by the surface's colour, which goes away towards grazing
// angles: POV-Ray's fit to Fresnel's equations, of x = the angle over a right angle.
template <class Real>
inline Rgb<Real> pov_metal_tint(Real metallic, Rgb<Real> color, Real cosine) {
  if (metallic == 0) return Rgb<Real>(Real(1));
  const Real x = 4 * acos_turns(smaller(cosine, Real(1)));
  const Real below = x - Real(1.12);
  const Real fit = Real(0.014567225) / (below * below) - Real(0.011612903);
  const Real share = metallic * (1 - larger(Real(0), smaller(Real(1), fit)));
  return Rgb<Real>(Real(1)) + share * (color - Rgb<Real>(Real(1)));
}

// What both highlights add to light 1. All directions are of unit length and point away from the
// surface, `normal` on the viewer's side and the light's.
template <class Real>
inline Rgb<Real> pov_highlights(const PovSurface<Real>& s, Rgb<Real> color, Vec3<Real> normal,
                                Vec3<Real> to_view, Vec3<Real> to_light) {
  const Real cos_light = dot(normal, to_light);
  Real sum = 0;
  if (s.phong != 0) {
    const Real along = 2 * (dot(normal, to_view) * cos_light) - dot(to_view, to_light);
    // POV-Ray leaves out what a sharp highlight would be far from its middle.
    const bool is_far = s.phong_size >= 60 && along <= Real(0.0008);
    if (along > 0 && !is_far) sum += s.phong * power(smaller(along, Real(1)), s.phong_size);
  }
  if (s.specular != 0) {
    const Real along = dot(normal, normalized(to_view + to_light));
    if (along > 0) {
      sum += s.specular * power(smaller(along, Real(1)), s.specular_exponent);
    }
  }
  if (sum == 0) return Rgb<Real>();
  return sum * pov_metal_tint(s.metallic, color, cos_light);
}

// What the matt part adds to light 1 at the cosine > 0: the cosine is part of it.
template <class Real>
inline Rgb<Real> pov_diffuse(const PovSurface<Real>& s, Rgb<Real> color, Real cosine) {
  return (s.diffuse * (s.brilliance == 1 ? cosine : power(cosine, s.brilliance))) * color;
}

// The reflectance for a view at `cosine` in [0, 1]; `fresnel` is Fresnel's at that angle, asked for
// by `s.fresnel` only.
template <class Real>
inline Rgb<Real> pov_reflectance(const PovSurface<Real>& s, Rgb<Real> color, Real cosine,
                                 Real fresnel) {
  const Real k = s.fresnel                ? fresnel
                 : s.reflect_falloff == 1 ? 1 - cosine
                                          : power(1 - cosine, s.reflect_falloff);
  return (s.reflect_min + k * (s.reflect_max - s.reflect_min)) *
         pov_metal_tint(s.reflect_metallic, color, cosine);
}

// What `conserve_energy` leaves for what passes.
template <class Real>
inline Rgb<Real> pov_rest(Rgb<Real> reflectance) {
  const auto rest = [](Real r) { return larger(Real(0), 1 - r); };
  return {rest(reflectance.r), rest(reflectance.g), rest(reflectance.b)};
}

// What a surface lets through, whatever the angle.
template <class Real>
inline Rgb<Real> pov_passed(const PovSurface<Real>& s, Rgb<Real> color) {
  return s.filter * color + Rgb<Real>(s.transmit);
}

// What is left after `distance` inside.
template <class Real>
inline Rgb<Real> pov_fade(const PovSurface<Real>& s, Real distance) {
  const Real depth = distance / s.fade_distance;
  const auto channel = [&](Real c) {
    if (c == 1) return Real(1);
    if (s.fade_power >= 1000) return exp_of((c - 1) * depth);
    return c + (1 - c) / (1 + power(depth, s.fade_power));
  };
  return {channel(s.fade_color.r), channel(s.fade_color.g), channel(s.fade_color.b)};
}

}  // namespace alhazen::render
