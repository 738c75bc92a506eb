// render/surface: the directions of mirrored and refracted rays.
#pragma once

#include "core/math/vec.h"
#include "render/surface/fresnel.h"

namespace alhazen::render {

// `direction` and `normal` of unit length; the normal may point to either side.
template <class Real>
inline Vec3<Real> reflected(Vec3<Real> direction, Vec3<Real> normal) {
  return multiply_add(-2 * dot(direction, normal), normal, direction);
}

// The refracted direction: eta d + (eta cos_i - cos_t) n, with `normal` on the side the ray comes
// from (dot(direction, normal) = -cos_i <= 0) and an interface that does not reflect totally.
// Taking the second factor as (eta^2 - 1) / (eta cos_i + cos_t) keeps its relative accuracy however
// small the step of index is: an index of exactly 1 returns the direction itself, bit for bit.
// The length is 1 within 8 u max(1, eta) for arguments of unit length to rounding.
template <class Real>
inline Vec3<Real> refracted(Vec3<Real> direction, Vec3<Real> normal, Real eta,
                            const DielectricInterface<Real>& interface) {
  return multiply_add(interface.bend, normal, eta * direction);
}

}  // namespace alhazen::render
