// render/camera: a ray that leaves the camera.
#pragma once

#include "core/math/vec.h"

namespace alhazen::render {

// Both in world axes, the origin measured from the camera's position (rebased coordinates): exactly
// 0 for a pinhole. The direction has unit length.
template <class Real>
struct CameraRay {
  Vec3<Real> origin, direction;
};

// A place in the picture. Whole pixels and the offset are kept apart, so that no bit of the offset
// is lost in wide pictures and mirrored pixels get exactly opposite places.
template <class Real>
struct FilmPoint {
  IntOf<Real> column = 0, row = 0;  // rows from the top
  Real offset_x = 0, offset_y = 0;  // from the pixel's centre, in pixels, y downwards
};

}  // namespace alhazen::render
