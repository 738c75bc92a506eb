// render/accel: which surface a ray meets first, by asking every shape of a table. The reference
// for shape_tree.h, which gives the same hits to the last bit.
#pragma once

#include <optional>

#include "render/accel/hit.h"

namespace alhazen::render {

// The first hit with 0 <= t <= t_max (which may be infinite), or nothing. `ignored` is not met: the
// visible surface of the light that a shadow ray is sent to.
template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored = kNoId);

// The first hit after `previous` in that order, on the same ray from the same source. Walking a
// straight line so, as shadow rays through glass do, visits each crossing once, also where surfaces
// coincide.
template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max,
                                  ShapeId ignored = kNoId);

// Whether there is a hit with 0 <= t <= t_max.
template <class Real>
bool any_hit(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored = kNoId);

}  // namespace alhazen::render
