// render/wave: how near what a ray met was to being something else, from the doubts of all shapes
// (shape/doubt.h). A plain loop: it runs only where a margin was asked for.
#pragma once

#include "render/wave/world.h"

namespace alhazen::render {

// Calls `visit(shape, doubt)` for every shape but `ignored`. Of surfaces that are one, the layer
// that is met is no doubt: only the one that stands in for all is asked.
template <class Real, class Visitor>
void for_each_doubt(const World<Real>& world, const Ray<Real>& ray, const Source& source,
                    ShapeId ignored, const Visitor& visit) {
  const Twins& twins = world.shapes.twins();
  for (ShapeId id = 0; id < world.shapes.size(); ++id) {
    if (id == twins.stand_in(ignored) || twins.is_hidden(id)) continue;
    const bool leaves = id == twins.stand_in(source.shape);
    const Departure from = leaves ? Departure{source.face, source.side} : Departure();
    for (const Doubt<Real>& doubt : world.shapes.doubts(id, ray, from))
      visit(id, doubt);
  }
}

// The margin of `hit`'s being what the ray meets, or of its meeting nothing. A crossing that lies
// behind the hit could only take its place by coming before it; a near miss behind it would have to
// do both.
template <class Real>
Real margin_of_hit(const World<Real>& world, const Ray<Real>& ray, const Source& source,
                   const Hit<Real>* hit) {
  const Real end = hit != nullptr ? hit->t : infinity<Real>();
  Real margin = 1;
  for_each_doubt(world, ray, source, kNoId, [&](ShapeId id, const Doubt<Real>& doubt) {
    const bool is_the_hit = hit != nullptr && id == world.shapes.twins().stand_in(hit->shape) &&
                            doubt.crosses && doubt.t == end;
    Real own = doubt.margin;
    if (!is_the_hit) {
      const Real order = relative_gap(doubt.t, end);
      if (doubt.t > end) {
        own = doubt.crosses ? order : larger(own, order);
      } else if (doubt.crosses) {  // passed: both sides are one medium
        own = smaller(own, order);
      }
    }
    margin = smaller(margin, own);
  });
  return margin;
}

// The margin of light's arriving over `distance`, or not. Light arrives when nothing is in the way,
// so it takes one doubt to darken it; and it is dark until the last of what is in the way is gone.
template <class Real>
Real margin_of_shadow(const World<Real>& world, const Ray<Real>& ray, const Source& source,
                      Real distance, ShapeId lamp, bool arrives) {
  Real nearest = 1, surest = 0;
  for_each_doubt(world, ray, source, lamp, [&](ShapeId id, const Doubt<Real>& doubt) {
    const Real order = relative_gap(doubt.t, distance);
    const bool within = doubt.t <= distance;
    const bool blocks = doubt.crosses && within && !world.lets_light_pass(id);
    if (blocks) surest = larger(surest, smaller(doubt.margin, order));
    const Real beyond = doubt.crosses ? order : larger(doubt.margin, order);
    const Real before = doubt.crosses ? smaller(doubt.margin, order) : doubt.margin;
    nearest = smaller(nearest, within ? before : beyond);
  });
  return arrives ? nearest : surest;
}

}  // namespace alhazen::render
