// render/accel: the hits of one shape that count.
#pragma once

#include "render/accel/hit.h"

namespace alhazen::render {

// Whether a ray that starts on another face through its own origin has to cross this one.
template <class Real>
inline bool is_ahead(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source,
                     ShapeId id, const Crossing<Real>& crossing) {
  if (source.shape == kNoId || id == source.shape || source.arrival == Vec3d()) return true;
  for (const Touched& touched : source.earlier) {
    if (touched.shape == id && touched.face == crossing.face) {
      return crossing.enters == (touched.side == Side::kAbove);
    }
  }
  const Vec3<Real> normal = table.plain_surface(id, ray, crossing).normal;
  return crossing.enters == (dot(Vec3<Real>(source.arrival), normal) < Real(0));
}

// Calls `visit` with every hit of the shape up to t_max until it returns false; whether it never
// did.
template <class Real, class Visitor>
inline bool for_each_hit(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source,
                         Real t_max, ShapeId id, const Visitor& visit) {
  const Departure from = id == source.shape ? Departure{source.face, source.side} : Departure();
  for (const Crossing<Real>& c : table.crossings(id, ray, from)) {
    if (!(c.t <= t_max)) continue;
    if (c.t == Real(0) && !is_ahead(table, ray, source, id, c)) continue;
    if (!visit(Hit<Real>{c.t, id, c.face, c.enters})) return false;
  }
  return true;
}

}  // namespace alhazen::render
