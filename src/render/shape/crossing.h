// render/shape: what every kernel takes and gives: rays, where they set out from, the points where
// they cross a surface.
//
// There is no smallest distance and no epsilon. A ray that sets out from a surface says so by
// identity, and the kernel leaves out the root that it knows to be zero (docs/numerics.md, 5.3).
// Any other surface counts over the closed interval t >= 0.
#pragma once

#include <array>
#include <cstdint>

#include "core/math/vec.h"

namespace alhazen::render {

// The points origin + t direction, t >= 0. The direction may have any length but zero; t is in
// units of it.
template <class Real>
struct Ray {
  Vec3<Real> origin, direction;

  Vec3<Real> at(Real t) const { return multiply_add(t, direction, origin); }
};

// A shape's faces are numbered from 0; what the numbers mean stands at the head of its kernel.
inline constexpr int kNoFace = -1;

// On which side of the surface a ray sets out: the side to which the outward normal points is
// above. A caller that knows (it reflected, or it transmitted) says so, and then rounding in the
// direction cannot let a ray out of a closed shape.
enum class Side : std::uint8_t { kByDirection, kAbove, kBelow };

// How a ray leaves the shape it is tested against: from one of its faces, or not from it at all.
struct Departure {
  int face = kNoFace;
  Side side = Side::kByDirection;

  bool from_surface() const { return face != kNoFace; }
};

// Whether a departing ray goes below the surface; `along_normal` has the sign of dot(n, direction).
template <class Real>
inline bool goes_below(Departure from, Real along_normal) {
  return from.side == Side::kBelow || (from.side == Side::kByDirection && along_normal < Real(0));
}

template <class Real>
struct Crossing {
  Real t;
  int face;
  bool enters;  // against the outward normal
};

// The crossings of one ray with one shape in order of t, all with 0 <= t < infinity. Every shape
// is convex or flat, so there are at most two.
template <class Real>
class Crossings {
 public:
  void add(Real t, int face, bool enters) {
    // Written so that a NaN is no crossing. The sum makes a -0 a +0.
    if (t >= Real(0) && t < infinity<Real>()) items_[count_++] = {t + Real(0), face, enters};
  }
  int size() const { return count_; }
  const Crossing<Real>& operator[](int i) const { return items_[i]; }
  const Crossing<Real>* begin() const { return items_.data(); }
  const Crossing<Real>* end() const { return items_.data() + count_; }

 private:
  std::array<Crossing<Real>, 2> items_{};
  int count_ = 0;
};

// The part of a line inside of a convex solid, as it is cut down by the solid's boundaries.
template <class Real>
struct Span {
  Real near = -infinity<Real>(), far = infinity<Real>();
  int near_face = kNoFace, far_face = kNoFace;
  bool empty = false;

  // Only a strictly tighter bound takes over, so that of equal ones the first face counts.
  void cut(Real from, int from_face, Real to, int to_face) {
    if (from > near) {
      near = from;
      near_face = from_face;
    }
    if (to < far) {
      far = to;
      far_face = to_face;
    }
  }
};

// The crossings of a ray from elsewhere with the solid that `span` was cut for.
template <class Real>
inline Crossings<Real> ends_of(const Span<Real>& span) {
  Crossings<Real> result;
  if (span.empty || !(span.near <= span.far)) return result;
  result.add(span.near, span.near_face, true);
  result.add(span.far, span.far_face, false);
  return result;
}

// The crossing of a ray from the solid's own surface that goes inside. It must come out: when
// rounding has put its origin outside, it does so at once.
template <class Real>
inline Crossings<Real> exit_of(const Span<Real>& span) {
  Crossings<Real> result;
  result.add(larger(Real(0), span.far), span.far_face, false);
  return result;
}

// What shading needs to know of a point on a surface, in the frame of the ray.
template <class Real>
struct Surface {
  Vec3<Real> position;        // projected onto the surface: independent of the error in t
  Vec3<Real> normal;          // geometric, outward, unit length
  Vec3<Real> shading_normal;  // unit length, never below the surface
  Real u, v;                  // the shape's own parametrisation; 0 where they were not asked for
};

}  // namespace alhazen::render
