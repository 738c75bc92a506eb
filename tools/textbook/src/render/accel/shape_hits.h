// render/accel, as textbooks have it: a hit counts when it is farther than a fixed distance, by
// whatever surface the ray sets out from. For tools/textbook-cost.
#pragma once

#include <optional>

#include "render/accel/hit.h"

namespace alhazen::render {

inline Departure departure_from(const Source& /*source*/, ShapeId /*id*/) {
  return {};
}

template <class Shapes, class Real, class Visitor>
inline bool for_each_hit(const Shapes& /*shapes*/, const Ray<Real>& /*ray*/,
                         const Source& /*source*/, Real t_max, ShapeId id,
                         const Crossings<Real>& crossings, const Visitor& visit) {
  const Real least = Real(1e-6);
  for (const Crossing<Real>& c : crossings) {
    if (!(c.t > least && c.t <= t_max)) continue;
    if (!visit(Hit<Real>{c.t, id, c.face, c.enters})) return false;
  }
  return true;
}
template <class Shapes, class Real, class Visitor>
inline bool for_each_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source,
                         Real t_max, ShapeId id, const Visitor& visit) {
  return for_each_hit(shapes, ray, source, t_max, id, shapes.crossings(id, ray, Departure()),
                      visit);
}

// What is looked for among hits that come in any order. visit_hits(to, take) calls take(hit) for
// all up to `to`, which is read anew each time, until it returns false; it may call it for others
// up to the `to` that it began with.
//
// The first hit after `previous`; without one, the first.
template <class Real, class VisitHits>
inline std::optional<Hit<Real>> first_after(const Hit<Real>* previous, Real t_max,
                                            const VisitHits& visit_hits) {
  std::optional<Hit<Real>> best;
  Real to = t_max;
  visit_hits(to, [&](const Hit<Real>& hit) {
    const bool late = previous == nullptr || precedes(*previous, hit);
    if (late && (!best || precedes(hit, *best))) {
      best = hit;
      to = hit.t;
    }
    return true;
  });
  return best;
}
// Whether there is any.
template <class Real, class VisitHits>
inline bool any_of(Real t_max, const VisitHits& visit_hits) {
  bool found = false;
  visit_hits(t_max, [&found](const Hit<Real>&) {
    found = true;
    return false;
  });
  return found;
}

}  // namespace alhazen::render
