// render/shape: how near a ray's crossings with a shape are to not being there, and its misses to
// being crossings: what the margin channel is made of.
//
// A margin is a share in [0, 1] of the numbers that were compared, so it is the same at every
// scale: 0 is a tie, and a decision of margin m stands while the ray's direction and place, seen
// from the shape, change by much less than the share m.
#pragma once

#include <algorithm>
#include <array>

#include "render/shape/crossing.h"

namespace alhazen::render {

// |a - b| / (|a| + |b|): 0 for equal numbers, 1 for ones of opposite sign or when one is infinite.
template <class Real>
inline Real relative_gap(Real a, Real b) {
  if (!is_finite(a) || !is_finite(b)) return Real(1);
  const Real sum = absolute(a) + absolute(b);
  return sum > Real(0) ? absolute(a - b) / sum : Real(0);
}

// |sum| over the sizes of what was added up; a sum of nothing is a tie.
template <class Real>
inline Real share_of(Real sum, Real terms) {
  return terms > Real(0) ? smaller(absolute(sum) / terms, Real(1)) : Real(0);
}

// A crossing, or a place at t >= 0 where there almost is one.
template <class Real>
struct Doubt {
  Real t;
  Real margin;   // of its being there, or of its not being there
  bool crosses;  // it is there
};

template <class Real>
class Doubts {
 public:
  // The root `t` of an equation: a crossing if it lies ahead. `exists` is the margin of there being
  // a root, `start` that of the starting point's not lying on the surface.
  void add_root(Real t, Real exists, Real start, bool counts = true) {
    if (t >= Real(0)) {
      if (t < infinity<Real>()) add({t, smaller(exists, start), counts});
    } else if (counts) {
      add({Real(0), start, false});
    }
  }
  // No root, but almost one near `t`.
  void add_miss(Real t, Real exists, Real start) {
    if (t >= Real(0)) {
      add({t, exists, false});
    } else {
      add({Real(0), larger(exists, start), false});
    }
  }
  const Doubt<Real>* begin() const { return items_.data(); }
  const Doubt<Real>* end() const { return items_.data() + count_; }

 private:
  void add(const Doubt<Real>& doubt) { items_[count_++] = doubt; }

  std::array<Doubt<Real>, 2> items_{};
  int count_ = 0;
};

// One boundary of a convex solid on the ray's line.
template <class Real>
struct Bound {
  Real t;
  Real start = 1;      // margin of the starting point's not lying on it
  bool counts = true;  // an open end is not a surface
};

// The boundaries of one solid, as they cut down its line.
template <class Real>
struct Bounds {
  std::array<Bound<Real>, 3> entries, exits;
  Bounds() {
    entries.fill({-infinity<Real>()});
    exits.fill({infinity<Real>()});
  }
};

// `certainty` is the margin of the boundaries' being there at all. Which of two boundaries comes
// first says what face is met, so their gaps count as well.
template <class Real>
inline Doubts<Real> doubts_between(Bounds<Real> bounds, Real certainty) {
  auto& [entries, exits] = bounds;
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.t > b.t; });
  std::sort(exits.begin(), exits.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  const Bound<Real>&near = entries[0], &far = exits[0];
  const Real gap = relative_gap(near.t, far.t);
  Doubts<Real> result;
  if (!(near.t <= far.t)) {
    result.add_miss((near.t + far.t) / Real(2), gap, larger(near.start, far.start));
    return result;
  }
  const Real exists = smaller(certainty, gap);
  const auto first_of = [exists](const auto& ends) {
    return smaller(exists, relative_gap(ends[0].t, ends[1].t));
  };
  if (is_finite(near.t)) result.add_root(near.t, first_of(entries), near.start, near.counts);
  if (is_finite(far.t)) result.add_root(far.t, first_of(exits), far.start, far.counts);
  return result;
}

}  // namespace alhazen::render
