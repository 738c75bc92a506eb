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
  MaskOf<Real> reversed = false;

  static auto fields(auto& quad) { return std::tie(quad.corners, quad.reversed); }
};

template <class Real>
struct ParallelogramHit {
  TriangleHit<Real> triangle;
  std::array<Vec3<Real>, 3> corners;
  Real u{}, v{};
};

template <class Real>
inline ParallelogramHit<Real> hit_halves(const Parallelogram<Real>& quad,
                                         const ShearedRay<Real>& sheared) {
  const auto& [a, b, c, d] = quad.corners;
  ParallelogramHit<Real> result;
  result.corners = {a, b, c};
  result.triangle = hit_sheared(sheared, result.corners);
  const MaskOf<Real> first = result.triangle.hit;
  if (!all(first)) {
    const TriangleHit<Real> other = hit_sheared(sheared, {a, c, d});
    result.triangle = select(first, result.triangle, other);
    result.corners = {a, select(first, b, c), select(first, c, d)};
  }
  const auto& weights = result.triangle.weights;
  const Real both = weights[1] + weights[2];
  result.u = select(first, both, weights[1]);
  result.v = select(first, weights[2], both);
  return result;
}

template <class Real>
inline CrossingPair<Real> crossings(const Parallelogram<Real>& quad, const ShearedRay<Real>& ray) {
  const TriangleHit<Real> hit = hit_halves(quad, ray).triangle;
  CrossingPair<Real> result;
  result.set_near(hit.hit, hit.t, 0, hit.enters != quad.reversed);
  return result;
}
template <class Real>
inline CrossingPair<Real> crossings(const Parallelogram<Real>& quad, const Ray<Real>& ray) {
  return crossings(quad, ShearedRay<Real>(ray));
}

// It is flat, so no ray that leaves it comes back.
template <class Real>
inline CrossingPair<Real> own_crossings(const Parallelogram<Real>& /*quad*/,
                                        const Ray<Real>& /*ray*/,
                                        const OwnDeparture<Real>& /*from*/) {
  return {};
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Parallelogram<Real>& quad, const Ray<Real>& ray,
                             const Crossing<Real>& /*crossing*/) {
  const ParallelogramHit<Real> hit = hit_halves(quad, ShearedRay<Real>(ray));
  const Vec3<Real> n = normal_of_edges(quad.corners[1] - quad.corners[0],
                                       quad.corners[3] - quad.corners[0], quad.reversed);
  return {weighted(hit.triangle.weights, hit.corners), n, n, smaller(hit.u, Real(1)),
          smaller(hit.v, Real(1))};
}

}  // namespace alhazen::render
