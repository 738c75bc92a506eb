// render/accel: which surface a ray meets first, by asking every shape. The reference for
// shape_tree.h and world_tree.h, which give the same hits to the last bit.
#pragma once

#include <optional>

#include "render/accel/hit.h"
#include "render/shape/world_shapes.h"

namespace alhazen::render {

// Shapes is a ShapeTable<Real> or the WorldShapes<Real>.

// The first hit with 0 <= t <= t_max (which may be infinite), or nothing. `ignored` is not met: the
// visible surface of the light that a shadow ray is sent to.
template <class Shapes, class Real>
std::optional<Hit<Real>> closest_hit(const Shapes& shapes, const Ray<Real>& ray,
                                     const Source& source, Real t_max, ShapeId ignored = kNoId);

// The first hit after `previous` in that order, on the same ray from the same source. Walking a
// straight line so, as shadow rays through glass do, visits each crossing once, also where surfaces
// coincide.
template <class Shapes, class Real>
std::optional<Hit<Real>> next_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source,
                                  const Hit<Real>& previous, Real t_max, ShapeId ignored = kNoId);

// Whether there is a hit with 0 <= t <= t_max.
template <class Shapes, class Real>
bool any_hit(const Shapes& shapes, const Ray<Real>& ray, const Source& source, Real t_max,
             ShapeId ignored = kNoId);

}  // namespace alhazen::render
