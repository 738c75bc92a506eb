// render/surface: light lost along a path inside of an absorbing medium.
#pragma once

#include "core/math/elementary.h"
#include "core/math/vec.h"

namespace alhazen::render {

// Beer and Lambert: the share of the light left after `distance` >= 0, absorption >= 0 per length.
// A channel that is not absorbed keeps all of its light, also over an infinite distance.
template <class Real>
inline Rgb<Real> transmitted_share(Rgb<Real> absorption, Real distance) {
  const auto channel = [distance](Real a) {
    const MaskOf<Real> absorbs = a != Real(0);
    return any(absorbs) ? select(absorbs, exp_of(-a * distance), Real(1)) : Real(1);
  };
  return {channel(absorption.r), channel(absorption.g), channel(absorption.b)};
}

}  // namespace alhazen::render
