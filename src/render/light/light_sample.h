// render/light: what a light sends to one point along one direction, and the frame to choose
// directions in.
#pragma once

#include "core/math/vec.h"

namespace alhazen::render {

// The light adds weight * f * max(0, dot(n, direction)) to the radiance leaving the point, where f
// is the reflectance distribution (albedo / pi for Lambert) and nothing stands between. For an area
// light the sum over its samples is the estimate: the weight holds 1 / samples.
template <class Real>
struct LightSample {
  Vec3<Real> direction;  // unit length, from the point to the light
  Real distance = 0;     // to the sampled point of the light; may be infinite
  Rgb<Real> weight{Real(0), Real(0), Real(0)};  // black: the point is not lit
};

// The sample where the point is lit, and elsewhere nothing.
template <class Real>
inline LightSample<Real> where_lit(MaskOf<Real> lit, const LightSample<Real>& sample) {
  if (all(lit)) return sample;
  return {select(lit, sample.direction, Vec3<Real>()), select(lit, sample.distance, Real(0)),
          select(lit, sample.weight, Rgb<Real>())};
}

// Two directions that make an orthonormal frame with the unit vector w, without a branch on its
// size (T. Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017).
template <class Real>
struct Tangents {
  Vec3<Real> a, b;
};
template <class Real>
inline Tangents<Real> tangents_of(Vec3<Real> w) {
  const Real sign = select(ScalarTraits<Real>::sign_bit(w.z), Real(-1), Real(1));
  const Real scale = -1 / (sign + w.z);
  const Real shared = w.x * w.y * scale;
  return {{1 + sign * w.x * w.x * scale, sign * shared, -sign * w.x},
          {shared, sign + w.y * w.y * scale, -w.y}};
}

}  // namespace alhazen::render
