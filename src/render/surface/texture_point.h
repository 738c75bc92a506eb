// render/surface: what a texture may ask about the point that it colours.
#pragma once

#include "core/math/vec.h"

namespace alhazen::render {

template <class Real>
struct TexturePoint {
  Vec3<Real> object;   // in the shape's object frame, before its own transforms
  Vec3<Real> rebased;  // in the world, measured from the origin of the rebasing (the camera)
  Real u = 0, v = 0;   // of the shape's parametrisation
};

}  // namespace alhazen::render
