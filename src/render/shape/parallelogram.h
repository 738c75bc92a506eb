// render/shape: the scene's quad: the parallelogram corner + u edge_u + v edge_v, u and v in [0,
// 1]. One face, 0; it encloses nothing. Two triangles that share a diagonal, so that quads with
// common corners are as watertight as triangles are.
#pragma once

#include "render/shape/triangle.h"

namespace alhazen::render {

template <class Real>
struct Parallelogram {
  // corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v
  std::array<Vec3<Real>, 4> corners;
  bool reversed = false;
};

template <class Real>
struct ParallelogramHit {
  TriangleHit<Real> triangle;
  std::array<Vec3<Real>, 3> corners;
  Real u{}, v{};
};

template <class Real>
inline ParallelogramHit<Real> hit_halves(const Parallelogram<Real>& quad, const Ray<Real>& ray) {
  const ShearedRay<Real> sheared(ray);
  ParallelogramHit<Real> result;
  result.corners = {quad.corners[0], quad.corners[1], quad.corners[2]};
  result.triangle = hit_sheared(sheared, result.corners);
  if (result.triangle.hit) {
    result.u = result.triangle.weights[1] + result.triangle.weights[2];
    result.v = result.triangle.weights[2];
    return result;
  }
  result.corners = {quad.corners[0], quad.corners[2], quad.corners[3]};
  result.triangle = hit_sheared(sheared, result.corners);
  result.u = result.triangle.weights[1];
  result.v = result.triangle.weights[1] + result.triangle.weights[2];
  return result;
}

template <class Real>
inline Crossings<Real> crossings(const Parallelogram<Real>& quad, const Ray<Real>& ray,
                                 Departure from) {
  Crossings<Real> result;
  if (from.from_surface()) return result;
  const TriangleHit<Real> hit = hit_halves(quad, ray).triangle;
  if (hit.hit) result.add(hit.t, 0, hit.enters != quad.reversed);
  return result;
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Parallelogram<Real>& quad, const Ray<Real>& ray,
                             const Crossing<Real>& /*crossing*/) {
  const ParallelogramHit<Real> hit = hit_halves(quad, ray);
  const Vec3<Real> n = normal_of_edges(quad.corners[1] - quad.corners[0],
                                       quad.corners[3] - quad.corners[0], quad.reversed);
  return {weighted(hit.triangle.weights, hit.corners), n, n, smaller(hit.u, Real(1)),
          smaller(hit.v, Real(1))};
}

}  // namespace alhazen::render
