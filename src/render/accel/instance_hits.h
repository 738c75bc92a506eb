// render/accel: one ray and one instance: its prototype's tree, in its prototype's frame.
#pragma once

#include "render/accel/shape_hits.h"
#include "render/accel/world_tree.h"

namespace alhazen::render {

// Calls take(hit) for the hits with from <= t <= to of an instance's shapes, and for others, but
// not those of the shape that the ray leaves nor of `ignored`, until it returns false; whether it
// never did. `to` is read anew each time.
template <class Real, class Take>
inline bool for_each_hit_of_instance(const WorldTree<Real>& tree, InstanceId instance,
                                     const Ray<Real>& ray, const Source& source, Real from,
                                     const Real& to, ShapeId ignored, const Take& take) {
  const WorldShapes<Real>& shapes = tree.shapes();
  const ShapeTree<Real>& prototype = tree.prototype_of(instance);
  const ShapeId first = shapes.index().first(instance);
  const Ray<Real> own = shapes.placement(instance).in_object(ray);
  return prototype.visit(own, from, to, [&](ShapeId number) {
    const ShapeId id = first + number;
    if (id == source.shape || id == ignored) return true;
    return for_each_hit(shapes, ray, source, to, id,
                        prototype.table().crossings(number, own, Departure()), take);
  });
}

}  // namespace alhazen::render
