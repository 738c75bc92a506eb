// render/shape: the part of a line that is inside of a convex solid.
#pragma once

#include "render/shape/crossing.h"

namespace alhazen::render {

// A line as it is cut down by a solid's boundaries.
template <class Real>
struct Span {
  using Mask = MaskOf<Real>;
  using Int = IntOf<Real>;

  Real near = -infinity<Real>(), far = infinity<Real>();
  Int near_face = kNoFace, far_face = kNoFace;
  Mask empty = false;

  // Only a strictly tighter bound takes over, so that of equal ones the first face counts.
  void cut(Real from, Int from_face, Real to, Int to_face, Mask where = true) {
    const Mask later = where && from > near, sooner = where && to < far;
    near = select(later, from, near);
    near_face = select(later, from_face, near_face);
    far = select(sooner, to, far);
    far_face = select(sooner, to_face, far_face);
  }
};

// The crossings of a ray from elsewhere with the solid that `span` was cut for.
template <class Real>
inline CrossingPair<Real> ends_of(const Span<Real>& span) {
  const MaskOf<Real> exists = !span.empty && span.near <= span.far;
  CrossingPair<Real> result;
  result.set_near(exists, span.near, span.near_face, true);
  result.set_far(exists, span.far, span.far_face, false);
  return result;
}

// The crossing of a ray from the solid's own surface that goes inside. It must come out: when
// rounding has put its origin outside, it does so at once.
template <class Real>
inline CrossingPair<Real> exit_of(const Span<Real>& span, MaskOf<Real> goes_inside) {
  CrossingPair<Real> result;
  result.set_far(goes_inside, larger(Real(0), span.far), span.far_face, false);
  return result;
}

}  // namespace alhazen::render
