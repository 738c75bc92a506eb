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
#include <tuple>

#include "render/shape/crossing.h"
#include "render/shape/quadratic.h"

namespace alhazen::render {

// A ray made ready for any number of triangles: which axis it mostly follows, and the shear.
template <class Real>
struct ShearedRay : Ray<Real> {
  using Ray<Real>::origin, Ray<Real>::direction;

  MaskOf<Real> along_x, along_y;  // else along z
  MaskOf<Real> backward;
  Real shear_x, shear_y, scale_z;

  explicit ShearedRay(const Ray<Real>& ray) : Ray<Real>(ray) {
    const Real ax = absolute(direction.x), ay = absolute(direction.y), az = absolute(direction.z);
    const MaskOf<Real> x_before_y = ax > ay;
    along_x = x_before_y && ax > az;
    along_y = !x_before_y && ay > az;
    backward = select(along_x, direction.x, select(along_y, direction.y, direction.z)) < Real(0);
    const Vec3<Real> d = turned(direction);
    shear_x = d.x / d.z;
    shear_y = d.y / d.z;
    scale_z = Real(1) / d.z;
  }

  // Turned until the ray mostly follows z, and mirrored if it goes down: that keeps the winding.
  Vec3<Real> turned(Vec3<Real> v) const {
    const Real x = select(along_x, v.y, select(along_y, v.z, v.x));
    const Real y = select(along_x, v.z, select(along_y, v.x, v.y));
    const Real z = select(along_x, v.x, select(along_y, v.y, v.z));
    return {select(backward, y, x), select(backward, x, y), z};
  }
  Vec3<Real> sheared(Vec3<Real> corner) const {
    const Vec3<Real> p = turned(corner - origin);
    return {fused_multiply_add(-shear_x, p.z, p.x), fused_multiply_add(-shear_y, p.z, p.y), p.z};
  }
};

// Where a line meets a triangle: corner weights (their sum is 1) and t, which may be negative.
template <class Real>
struct TriangleHit {
  MaskOf<Real> hit = false, enters = false;
  std::array<Real, 3> weights{};
  Real t{};
};

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) inline TriangleHit<Real> select(
    MaskOf<Real> which, const TriangleHit<Real>& yes, const TriangleHit<Real>& no) {
  const auto weight = [&](std::size_t i) { return select(which, yes.weights[i], no.weights[i]); };
  return {(which && yes.hit) || (!which && no.hit),
          (which && yes.enters) || (!which && no.enters),
          {weight(0), weight(1), weight(2)},
          select(which, yes.t, no.t)};
}

// p.x q.y - p.y q.x, the same bits with the opposite sign when p and q change places, so that a
// mirrored triangle is hit in the mirrored place.
template <class Real>
inline Real edge_function(Vec3<Real> p, Vec3<Real> q) {
  return select(absolute(p.x * q.y) < absolute(p.y * q.x),
                -difference_of_products(q.x, p.y, q.y, p.x),
                difference_of_products(p.x, q.y, p.y, q.x));
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
  const MaskOf<Real> outside =
      (u < zero || v < zero || w < zero) && (u > zero || v > zero || w > zero);
  const Real sum = u + v + w;
  TriangleHit<Real> result;
  // No area, or seen edge-on: where the shear has made a line of the triangle, and where rounding
  // has given width to that line. Only a sum within its own rounding can be such a one.
  result.hit = !outside && sum != zero;
  if (!any(result.hit)) return result;
  const Real reach = manhattan(a) + manhattan(b) + manhattan(c);
  const MaskOf<Real> thin =
      result.hit && absolute(sum) < 16 * ScalarTraits<Real>::unit_roundoff() * reach * reach;
  if (any(thin)) {
    const Vec3<Real> n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    result.hit = result.hit && !(thin && sharp_dot(n, ray.direction, thin) == zero);
  }
  result.weights = {u / sum, v / sum, w / sum};
  const Real z = fused_multiply_add(
      result.weights[0], a.z, fused_multiply_add(result.weights[1], b.z, result.weights[2] * c.z));
  result.t = z * ray.scale_z;
  // dot(cross(b - a, c - a), direction) = -sum |d_z|: a shear keeps triple products.
  result.enters = sum > zero;
  return result;
}

template <class Real>
struct Triangle {
  std::array<Vec3<Real>, 3> corners;
  std::array<Vec3<Real>, 3> normals{};  // at the corners, if `smooth`
  MaskOf<Real> smooth = false;
  // The normal is -cross(b - a, c - a): a mirroring transform has been here.
  MaskOf<Real> reversed = false;

  static auto fields(auto& t) { return std::tie(t.corners, t.normals, t.smooth, t.reversed); }
};

template <class Real>
inline CrossingPair<Real> crossings(const Triangle<Real>& triangle, const ShearedRay<Real>& ray) {
  const TriangleHit<Real> hit = hit_sheared(ray, triangle.corners);
  CrossingPair<Real> result;
  result.set_near(hit.hit, hit.t, 0, hit.enters != triangle.reversed);
  return result;
}
template <class Real>
inline CrossingPair<Real> crossings(const Triangle<Real>& triangle, const Ray<Real>& ray) {
  return crossings(triangle, ShearedRay<Real>(ray));
}

// It is flat, so no ray that leaves it comes back.
template <class Real>
inline CrossingPair<Real> own_crossings(const Triangle<Real>& /*triangle*/,
                                        const Ray<Real>& /*ray*/,
                                        const OwnDeparture<Real>& /*from*/) {
  return {};
}

// The unit normal of the parallelogram of two edges. Each edge is first brought to a length near 1
// on its own, so that neither needles nor scales lose the product.
template <class Real>
inline Vec3<Real> normal_of_edges(Vec3<Real> first, Vec3<Real> second, MaskOf<Real> reversed) {
  const Vec3<Real> n = normalized(cross(normalized(first), normalized(second)));
  return select(reversed, -n, n);
}

template <class Real>
inline Vec3<Real> weighted(const std::array<Real, 3>& weights,
                           const std::array<Vec3<Real>, 3>& values) {
  return multiply_add(weights[0], values[0],
                      multiply_add(weights[1], values[1], weights[2] * values[2]));
}

// The mean of the normals at the corners. Normals given against the winding are turned over; a
// mean of no direction is not used.
template <class Real>
inline Vec3<Real> smooth_normal(const Triangle<Real>& triangle, const std::array<Real, 3>& weights,
                                Vec3<Real> flat) {
  const Vec3<Real> mean = weighted(weights, triangle.normals), n = normalized(mean);
  const Real above = dot(mean, flat);
  const Vec3<Real> bent = select(above > Real(0), n, select(above < Real(0), -n, flat));
  return select(triangle.smooth, bent, flat);
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Triangle<Real>& triangle, const Ray<Real>& ray,
                             const Crossing<Real>& /*crossing*/) {
  const auto& [a, b, c] = triangle.corners;
  const TriangleHit<Real> hit = hit_sheared(ShearedRay<Real>(ray), triangle.corners);
  const Vec3<Real> n = normal_of_edges(b - a, c - a, triangle.reversed);
  const Vec3<Real> shading = any(triangle.smooth) ? smooth_normal(triangle, hit.weights, n) : n;
  return {weighted(hit.weights, triangle.corners), n, shading, hit.weights[1], hit.weights[2]};
}

}  // namespace alhazen::render
