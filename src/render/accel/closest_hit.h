// render/accel: which surface a ray meets first. Brute force over the table: the BVH that replaces
// it must give the same hits, to the last bit, behind the same functions.
#pragma once

#include <optional>

#include "render/shape/shape_table.h"

namespace alhazen::render {

// What the ray leaves. By default nothing: a ray of the camera.
struct Source {
  ShapeId shape = kNoId;
  int face = kNoFace;
  Side side = Side::kByDirection;
};

template <class Real>
struct Hit {
  Real t;  // in units of the ray's direction, as the caller gave it
  ShapeId shape;
  int face;
  bool enters;  // against the outward normal

  Crossing<Real> crossing() const { return {t, face, enters}; }
};

// The order of hits along a ray. Coincident surfaces are ordered by rule, not by chance: entering
// before leaving, then by shape and face, so that one solid that ends where another begins leaves
// no gap.
template <class Real>
inline bool precedes(const Hit<Real>& a, const Hit<Real>& b) {
  if (a.t != b.t) return a.t < b.t;
  if (a.enters != b.enters) return a.enters;
  return a.shape != b.shape ? a.shape < b.shape : a.face < b.face;
}

// The first hit with 0 <= t <= t_max (which may be infinite), or nothing.
template <class Real>
std::optional<Hit<Real>> closest_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                     const Source& source, Real t_max);

// The first hit after `previous` in that order, on the same ray from the same source. Walking a
// straight line so, as shadow rays through glass do, visits each crossing once, also where surfaces
// coincide.
template <class Real>
std::optional<Hit<Real>> next_hit(const ShapeTable<Real>& table, const Ray<Real>& ray,
                                  const Source& source, const Hit<Real>& previous, Real t_max);

// Whether there is a hit with 0 <= t <= t_max.
template <class Real>
bool any_hit(const ShapeTable<Real>& table, const Ray<Real>& ray, const Source& source, Real t_max);

}  // namespace alhazen::render
