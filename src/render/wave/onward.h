// render/wave: where rays go on from what they have met.
#pragma once

#include "render/surface/fresnel.h"
#include "render/surface/refract.h"
#include "render/wave/spawn.h"

namespace alhazen::render {

// The mirror direction about the shading normal, or, where that would lead through the surface,
// about the geometric one.
template <class L>
Vec3<L> mirror_direction(const Meeting<L>& met) {
  const Vec3<L> mirrored = reflected(met.incident, met.shading_normal);
  const MaskOf<L> comes_below = dot(met.incident, met.geometric_normal) < L(0);
  const MaskOf<L> stays = (dot(mirrored, met.geometric_normal) < L(0)) != comes_below;
  if (all(stays)) return mirrored;
  return select(stays, mirrored, reflected(met.incident, met.geometric_normal));
}

// The cosine of the angle of incidence against the shading normal, kept within [0, 1].
template <class L>
L incident_cosine(const Meeting<L>& met) {
  const L cosine = -dot(met.incident, met.shading_normal);
  return larger(L(0), smaller(L(1), cosine));
}

template <class Real, class L>
Offspring<L> reflection(const Wave<Real>& wave, const Meeting<L>& met, MaskOf<L> exists,
                        const Rgb<L>& reflectance) {
  return {true, exists, mirror_direction(met), met.weight * reflectance,
          met.rays.of(wave.rays.medium)};
}

// Where rays go on that cross a surface. Smooth normals can bend a ray back; then it goes straight
// on.
template <class L>
Vec3<L> crossing_direction(const Meeting<L>& met, L eta, const DielectricInterface<L>& interface) {
  const Vec3<L> onward = refracted(met.incident, met.shading_normal, eta, interface);
  const MaskOf<L> crosses = (dot(onward, met.geometric_normal) < L(0)) == met.enters;
  return select(crosses, onward, met.incident);
}

}  // namespace alhazen::render
