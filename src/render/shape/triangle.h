// render/shape: the triangle. One face, 0; it encloses nothing.
//
// Watertight after S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1),
// 2013: the corners are sheared so that the ray runs along z, and three signs of edges decide. Two
// triangles that share an edge see the same sheared corners, and the edge functions here (error
// below 1.5 ulp) have the right sign without exception, so the edge belongs to one of them, or to
// both. The paper's fallback to higher precision is not needed.
//
// (u, v) are the weights of the second and the third corner.
#pragma once

#include <array>

#include "render/shape/crossing.h"
#include "render/shape/quadratic.h"

namespace alhazen::render {

// A ray made ready for any number of triangles: which axis it mostly follows, and the shear.
template <class Real>
struct ShearedRay {
  int x, y, z;
  Real shear_x, shear_y, scale_z;
  Vec3<Real> origin, direction;

  explicit ShearedRay(const Ray<Real>& ray) : origin(ray.origin), direction(ray.direction) {
    const Vec3<Real> d = direction;
    const Real ax = absolute(d.x), ay = absolute(d.y), az = absolute(d.z);
    z = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
    x = (z + 1) % 3;
    y = (z + 2) % 3;
    if (d[z] < Real(0)) {  // keeps the winding
      const int swapped = x;
      x = y;
      y = swapped;
    }
    shear_x = d[x] / d[z];
    shear_y = d[y] / d[z];
    scale_z = Real(1) / d[z];
  }

  Vec3<Real> sheared(Vec3<Real> corner) const {
    const Vec3<Real> p = corner - origin;
    return {fused_multiply_add(-shear_x, p[z], p[x]), fused_multiply_add(-shear_y, p[z], p[y]),
            p[z]};
  }
};

// Where a line meets a triangle: corner weights (their sum is 1) and t, which may be negative.
template <class Real>
struct TriangleHit {
  bool hit = false, enters = false;
  std::array<Real, 3> weights{};
  Real t{};
};

// p.x q.y - p.y q.x, the same bits with the opposite sign when p and q change places, so that a
// mirrored triangle is hit in the mirrored place.
template <class Real>
inline Real edge_function(Vec3<Real> p, Vec3<Real> q) {
  return absolute(p.x * q.y) < absolute(p.y * q.x) ? -difference_of_products(q.x, p.y, q.y, p.x)
                                                   : difference_of_products(p.x, q.y, p.y, q.x);
}

template <class Real>
inline Real manhattan(Vec3<Real> a) {
  return absolute(a.x) + absolute(a.y) + absolute(a.z);
}

template <class Real>
inline TriangleHit<Real> hit_sheared(const ShearedRay<Real>& ray,
                                     const std::array<Vec3<Real>, 3>& corners) {
  const Vec3<Real> a = ray.sheared(corners[0]), b = ray.sheared(corners[1]),
                   c = ray.sheared(corners[2]);
  const Real u = edge_function(c, b);
  const Real v = edge_function(a, c);
  const Real w = edge_function(b, a);
  const Real zero(0);
  TriangleHit<Real> result;
  if ((u < zero || v < zero || w < zero) && (u > zero || v > zero || w > zero)) return result;
  const Real sum = u + v + w;
  // No area, or seen edge-on: where the shear has made a line of the triangle, and where rounding
  // has given width to that line. Only a sum within its own rounding can be such a one.
  if (sum == zero) return result;
  const Real reach = manhattan(a) + manhattan(b) + manhattan(c);
  if (absolute(sum) < 16 * ScalarTraits<Real>::unit_roundoff() * reach * reach &&
      sharp_dot(cross(corners[1] - corners[0], corners[2] - corners[0]), ray.direction) == zero) {
    return result;
  }
  result.weights = {u / sum, v / sum, w / sum};
  const Real z = fused_multiply_add(
      result.weights[0], a.z, fused_multiply_add(result.weights[1], b.z, result.weights[2] * c.z));
  result.t = z * ray.scale_z;
  // dot(cross(b - a, c - a), direction) = -sum |d_z|: a shear keeps triple products.
  result.enters = sum > zero;
  result.hit = true;
  return result;
}

template <class Real>
struct Triangle {
  std::array<Vec3<Real>, 3> corners;
  std::array<Vec3<Real>, 3> normals{};  // at the corners, if `smooth`
  bool smooth = false;
  bool reversed = false;  // the normal is -cross(b - a, c - a): a mirroring transform has been here
};

template <class Real>
inline Crossings<Real> crossings(const Triangle<Real>& triangle, const Ray<Real>& ray,
                                 Departure from) {
  Crossings<Real> result;
  if (from.from_surface()) return result;
  const TriangleHit<Real> hit = hit_sheared(ShearedRay<Real>(ray), triangle.corners);
  if (hit.hit) result.add(hit.t, 0, hit.enters != triangle.reversed);
  return result;
}

// The unit normal of the parallelogram of two edges. Each edge is first brought to a length near 1
// on its own, so that neither needles nor scales lose the product.
template <class Real>
inline Vec3<Real> normal_of_edges(Vec3<Real> first, Vec3<Real> second, bool reversed) {
  const Vec3<Real> n = normalized(cross(normalized(first), normalized(second)));
  return reversed ? -n : n;
}

template <class Real>
inline Vec3<Real> weighted(const std::array<Real, 3>& weights,
                           const std::array<Vec3<Real>, 3>& values) {
  return multiply_add(weights[0], values[0],
                      multiply_add(weights[1], values[1], weights[2] * values[2]));
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Triangle<Real>& triangle, const Ray<Real>& ray,
                             const Crossing<Real>& /*crossing*/) {
  const auto& [a, b, c] = triangle.corners;
  const TriangleHit<Real> hit = hit_sheared(ShearedRay<Real>(ray), triangle.corners);
  const Vec3<Real> n = normal_of_edges(b - a, c - a, triangle.reversed);
  Vec3<Real> shading = n;
  if (triangle.smooth) {
    const Vec3<Real> mean = weighted(hit.weights, triangle.normals);
    const Real above = dot(mean, n);
    // Normals given against the winding are turned over; a mean of no direction is not used.
    if (above > Real(0)) shading = normalized(mean);
    if (above < Real(0)) shading = -normalized(mean);
  }
  return {weighted(hit.weights, triangle.corners), n, shading, hit.weights[1], hit.weights[2]};
}

}  // namespace alhazen::render
