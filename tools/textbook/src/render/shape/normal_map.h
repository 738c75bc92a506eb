// render/shape, as textbooks have it: a normal under the inverse transposed. For
// tools/textbook-cost.
#pragma once

#include "core/math/transform.h"

namespace alhazen::render {

template <class Real>
inline Vec3<Real> normal_in_world(const Affine<Real>& /*world_from_object*/,
                                  const Affine<Real>& object_from_world, Vec3<Real> n) {
  return normalized(object_from_world.transposed(n));
}

}  // namespace alhazen::render
