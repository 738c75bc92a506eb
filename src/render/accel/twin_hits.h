// render/accel: queries where some shapes are one surface (shape/twins.h), by way of queries of the
// shapes that stand in for them.
//
// The layers of a stack follow each other at one t, in the order of the ray's way through them:
// nothing else comes between. So a ray that leaves a layer towards another is there at once, at t =
// 0, and nothing is searched for; one that leaves the last layer, leaves the stand-in. Shapes is a
// ShapeTable or the WorldShapes.
#pragma once

#include <optional>

#include "render/accel/hit.h"

namespace alhazen::render {

inline Source standing_in(const Twins& twins, Source source) {
  source.shape = twins.stand_in(source.shape);
  for (Touched& touched : source.earlier)
    touched.shape = twins.stand_in(touched.shape);
  return source;
}

template <class Shapes, class Real>
inline bool goes_inward(const Shapes& table, const Ray<Real>& ray, const Source& source) {
  if (source.side != Side::kByDirection) return source.side == Side::kBelow;
  const Crossing<Real> start{Real(0), source.face, true};
  return dot(table.plain_surface(source.shape, ray, start).normal, ray.direction) < Real(0);
}

// The next layer, of a ray that sets out from a layer.
template <class Shapes, class Real>
inline std::optional<Hit<Real>> hit_on_next_layer(const Shapes& table, const Ray<Real>& ray,
                                                  const Source& source, ShapeId ignored) {
  const Twins& twins = table.twins();
  if (source.face == kNoFace || !twins.has_twin(source.shape)) return std::nullopt;
  if (twins.stand_in(source.shape) == twins.stand_in(ignored)) return std::nullopt;
  const bool inward = goes_inward(table, ray, source);
  const ShapeId next = twins.after(source.shape, inward);
  if (next == kNoId) return std::nullopt;
  return Hit<Real>{Real(0), next, source.face, inward};
}

template <class Real>
inline std::optional<Hit<Real>> on_first_layer(const Twins& twins, std::optional<Hit<Real>> hit) {
  if (hit) hit->shape = twins.first(hit->shape, hit->enters);
  return hit;
}

// What closest_hit says, where search(source, ignored) says it of stand-ins. A lamp is ignored with
// all its twins: its light comes from the outermost layer.
template <class Shapes, class Real, class Search>
inline std::optional<Hit<Real>> closest_layer(const Shapes& table, const Ray<Real>& ray,
                                              const Source& source, ShapeId ignored,
                                              const Search& search) {
  const Twins& twins = table.twins();
  if (twins.none()) return search(source, ignored);
  if (const auto hit = hit_on_next_layer(table, ray, source, ignored)) return hit;
  return on_first_layer(twins, search(standing_in(twins, source), twins.stand_in(ignored)));
}

// What next_hit says, where search(source, previous, ignored) says it of stand-ins; without a
// previous hit, what closest_hit says.
template <class Shapes, class Real, class Search>
inline std::optional<Hit<Real>> next_layer(const Shapes& table, const Ray<Real>& ray,
                                           const Source& source, Hit<Real> previous,
                                           ShapeId ignored, const Search& search) {
  const Twins& twins = table.twins();
  if (twins.none()) return search(source, &previous, ignored);
  if (const ShapeId layer = twins.after(previous.shape, previous.enters); layer != kNoId) {
    previous.shape = layer;
    return previous;
  }
  const Source from = standing_in(twins, source);
  previous.shape = twins.stand_in(previous.shape);
  ignored = twins.stand_in(ignored);
  // The layers at the start come before all that a search from there may find.
  const bool at_start = previous.t == Real(0) && twins.has_twin(source.shape) &&
                        previous.shape == from.shape && previous.face == source.face &&
                        previous.enters == goes_inward(table, ray, source);
  return on_first_layer(twins, search(from, at_start ? nullptr : &previous, ignored));
}

// What any_hit says, where search(source, ignored) says it of stand-ins.
template <class Shapes, class Real, class Search>
inline bool any_layer(const Shapes& table, const Ray<Real>& ray, const Source& source,
                      ShapeId ignored, const Search& search) {
  const Twins& twins = table.twins();
  if (twins.none()) return search(source, ignored);
  return hit_on_next_layer(table, ray, source, ignored).has_value() ||
         search(standing_in(twins, source), twins.stand_in(ignored));
}

}  // namespace alhazen::render
