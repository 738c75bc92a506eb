// render/shape: a ray, where it comes from, and what it meets. No ray has a least distance: what it
// must not meet again is known by identity (docs/numerics.md).
#pragma once

#include <cstdint>

#include "core/math/vec.h"
#include "core/scene/shape.h"

namespace alhazen::render {

// A face of a shape: which cap of a cylinder, which side of a box. Numbered by each shape's own
// header.
using FaceId = std::uint32_t;

struct SurfaceId {
  ShapeId shape = kNoId;
  FaceId face = 0;

  bool known() const { return shape != kNoId; }
  friend bool operator==(SurfaceId, SurfaceId) = default;
};

// How a ray came to start where it does. A ray from a camera or a light departs from nothing.
//
// `surface` is the face it leaves, whose root at t = 0 is known and divided out. Other faces may
// pass through the very same point: a corner of a room, a box that stands on a plane. At such a
// face X, with normal n, the side the ray is on before it starts follows from `arrival`, the
// direction in which it reached the point: it stands where -arrival points, unless X is `earlier`,
// touched at this same point just before; then it already stands where arrival points. The ray
// meets X at t = 0 if and only if its direction leads to the other side.
template <class Real>
struct Departure {
  SurfaceId surface;
  Vec3<Real> arrival;
  SurfaceId earlier;
};

template <class Real>
struct Ray {
  Vec3<Real> origin;
  Vec3<Real> direction;  // of unit length to rounding in the world; any length in object frames
};

// The closest of a ray's meetings, t in [0, t_max] in units of the direction's length.
template <class Real>
struct Hit {
  Real t;
  SurfaceId surface;
};

}  // namespace alhazen::render
