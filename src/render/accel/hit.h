// render/accel: where rays start, what they meet, and the order of it.
#pragma once

#include <algorithm>
#include <array>

#include "render/shape/shape_table.h"

namespace alhazen::render {

// A face through a ray's starting point that the ray has met there, and the side it then went on
// by.
struct Touched {
  ShapeId shape = kNoId;
  int face = kNoFace;
  Side side = Side::kByDirection;
};

// Where a ray starts. By default nowhere in particular: a ray of the camera.
//
// The face that it leaves is divided out by identity. Other faces may pass through the very same
// point: a corner of a room, a box that stands on a plane. Such a face is met at t = 0 if and only
// if the ray has to get to its other side, and the side that it stands on is known: the point was
// reached in the direction `arrival`, so the ray stands where -arrival points; but of a face that
// has been met at this point (`earlier`, the latest first), where it went on from there. Three
// faces in general position share a point; four boxes side by side bring two more together.
struct Source {
  ShapeId shape = kNoId;
  int face = kNoFace;
  Side side = Side::kByDirection;
  Vec3d arrival;  // 0: not known, every face at t = 0 is met
  std::array<Touched, 4> earlier{};

  void remember(Touched touched) {
    std::copy_backward(earlier.begin(), earlier.end() - 1, earlier.end());
    earlier[0] = touched;
  }
};

template <class Real>
struct Hit {
  Real t;  // in units of the ray's direction, as the caller gave it
  ShapeId shape;
  int face;
  bool enters;  // against the outward normal

  Crossing<Real> crossing() const { return {t, face, enters}; }
};

// Where a ray goes on that came from `before` along `direction` and met `hit`: back from the
// surface, or across it.
template <class Real>
inline Source source_after(const Source& before, Vec3<Real> direction, const Hit<Real>& hit,
                           bool across) {
  Source after{hit.shape, hit.face, hit.enters == across ? Side::kBelow : Side::kAbove,
               Vec3d(direction)};
  if (hit.t == Real(0) && before.shape != kNoId) {
    after.arrival = before.arrival;
    after.earlier = before.earlier;
    after.remember({before.shape, before.face, before.side});
  }
  return after;
}

// The order of hits along a ray. Coincident surfaces are ordered by rule, not by chance: entering
// before leaving, then by shape and face, so that one solid that ends where another begins leaves
// no gap.
template <class Real>
inline bool precedes(const Hit<Real>& a, const Hit<Real>& b) {
  if (a.t != b.t) return a.t < b.t;
  if (a.enters != b.enters) return a.enters;
  return a.shape != b.shape ? a.shape < b.shape : a.face < b.face;
}

}  // namespace alhazen::render
