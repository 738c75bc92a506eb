// render/accel: the hits of one shape that count.
#pragma once

#include <optional>

#include "render/accel/hit.h"

namespace alhazen::render {

// Whether a ray that starts on another face through its own origin has to cross this one. Shapes is
// a ShapeTable or the WorldShapes; the ray is in its frame.
template <class Shapes, class Real>
inline bool is_ahead(const Shapes& shapes, const Ray<Real>& ray, const Source& source, ShapeId id,
                     const Crossing<Real>& crossing) {
  if (source.shape == kNoId || id == source.shape || source.arrival == Vec3d()) return true;
  for (const Touched& touched : source.earlier) {
    if (touched.shape == id && touched.face == crossing.face) {
      return crossing.enters == (touched.side == Side::kAbove);
    }
  }
  const Vec3<Real> normal = shapes.plain_surface(id, ray, crossing).normal;
  return crossing.enters == (dot(Vec3<Real>(source.arrival), normal) < Real(0));
}

inline Departure departure_from(const Source& source, ShapeId id) {
  return id == source.shape ? Departure{source.face, source.side} : Departure();
}

// Calls `visit` with those of a shape's crossings that are hits up to t_max until it returns false;
// whether it never did.
template <class Shapes, class Real, class Visitor>
inline bool for_each_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source,
                         Real t_max, ShapeId id, const Crossings<Real>& crossings,
                         const Visitor& visit) {
  for (const Crossing<Real>& c : crossings) {
    if (!(c.t <= t_max)) continue;
    if (c.t == Real(0) && !is_ahead(shapes, ray, source, id, c)) continue;
    if (!visit(Hit<Real>{c.t, id, c.face, c.enters})) return false;
  }
  return true;
}
template <class Shapes, class Real, class Visitor>
inline bool for_each_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source,
                         Real t_max, ShapeId id, const Visitor& visit) {
  return for_each_hit(shapes, ray, source, t_max, id,
                      shapes.crossings(id, ray, departure_from(source, id)), visit);
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
