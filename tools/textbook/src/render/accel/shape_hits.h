// render/accel, as textbooks have it: a hit counts when it is farther than a fixed distance, by
// whatever surface the ray sets out from. For tools/textbook-cost.
#pragma once

#include "render/accel/hit.h"

namespace alhazen::render {

template <class Real, class Visitor>
inline bool for_each_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                         const Source& /*source*/, Real t_max, ShapeId id, const Visitor& visit) {
  const Real least = Real(1e-6);
  for (const Crossing<Real>& c : table.crossings(id, ray, Departure())) {
    if (!(c.t > least && c.t <= t_max)) continue;
    if (!visit(Hit<Real>{c.t, id, c.face, c.enters})) return false;
  }
  return true;
}

}  // namespace alhazen::render
