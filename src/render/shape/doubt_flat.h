// render/shape: the doubts (doubt.h) of the plane, the disc, the triangle and the parallelogram. A
// ray that leaves one has nothing to decide.
#pragma once

#include "render/shape/disc.h"
#include "render/shape/doubt.h"
#include "render/shape/parallelogram.h"
#include "render/shape/plane.h"

namespace alhazen::render {

// n.d against |n| |d|, and offset - n.o against |offset| + |n| |o|. A ray away from the plane is
// one turn of n.d's sign from a crossing as far in front as the crossing is behind.
template <class Real>
inline Doubts<Real> doubts(const Plane<Real>& plane, const Ray<Real>& ray, Departure from) {
  Doubts<Real> result;
  if (from.from_surface()) return result;
  const Real along = sharp_dot(plane.normal, ray.direction);
  const Real ahead = depth_below(plane, ray.origin);
  const Real turn = share_of(along, length(ray.direction));
  const Real start = share_of(ahead, absolute(plane.offset) + length(ray.origin));
  const Real t = ahead / along;
  if (along == Real(0)) {
    result.add_miss(infinity<Real>(), turn, start);
  } else if (t >= Real(0)) {
    result.add_root(t, turn, start);
  } else {
    result.add_root(t, turn, start);
    result.add_miss(-t, turn, start);
  }
  return result;
}

// The distance from the centre against the radii, both squared, in shares of the distance from the
// origin and foreshortened as the disc is.
template <class Real>
inline Doubts<Real> doubts(const Disc<Real>& disc, const Ray<Real>& ray, Departure from) {
  Doubts<Real> result;
  const Vec3<Real> d = disc.frame.local_vector(ray.direction);
  if (from.from_surface()) return result;
  const Vec3<Real> o = disc.frame.local_point(ray.origin);
  const Real cosine = share_of(d.z, length(d));
  const Real start = share_of(o.z, length(ray.origin - disc.frame.origin));
  if (d.z == Real(0)) {
    result.add_miss(Real(0), start, start);
    return result;
  }
  const Real t = -o.z / d.z;
  const Real x = fused_multiply_add(t, d.x, o.x), y = fused_multiply_add(t, d.y, o.y);
  const Real squared = fused_multiply_add(x, x, y * y), reach = dot(o, o);
  const Real outer = disc.radius * disc.radius, inner = disc.hole_radius * disc.hole_radius;
  const auto rim = [&](Real edge) {
    return cosine * share_of(squared - edge, squared + edge + reach);
  };
  const bool within = squared <= outer && squared >= inner;
  if (within) {
    const Real hole = inner > Real(0) ? rim(inner) : Real(1);
    result.add_root(t, smaller(cosine, smaller(rim(outer), hole)), start);
  } else {
    result.add_miss(t, squared > outer ? rim(outer) : rim(inner), start);
  }
  return result;
}

// The ray's distance from the lines of the edges, seen along the ray, as a share of the distance of
// the corners. A crossing is lost at the nearest edge; a miss ends when the last edge that the ray
// is on the wrong side of has been crossed.
template <class Real, std::size_t count>
inline Doubts<Real> doubts_of_polygon(const std::array<Vec3<Real>, count>& corners,
                                      const Ray<Real>& ray, const TriangleHit<Real>& hit) {
  const ShearedRay<Real> sheared(ray);
  std::array<Vec3<Real>, count> seen;
  Real far = 0, area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    seen[i] = sheared.sheared(corners[i]);
    far = larger(far, length(seen[i]));
  }
  std::array<Real, count> side;
  for (std::size_t i = 0; i < count; ++i) {
    side[i] = edge_function(seen[(i + 1) % count], seen[i]);
    area = area + side[i];
  }
  Real nearest = 1, worst = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3<Real> edge = seen[(i + 1) % count] - seen[i];
    const Real width = square_root(fused_multiply_add(edge.x, edge.x, edge.y * edge.y));
    if (width == Real(0)) continue;  // seen end-on: the others decide
    const Real share = share_of(side[i], width * far);
    nearest = smaller(nearest, share);
    const Real outward = area < Real(0) ? side[i] : -side[i];
    if (outward > Real(0)) worst = larger(worst, share);
  }
  const Vec3<Real> to_corner = corners[0] - ray.origin;
  const Vec3<Real> normal =
      cross(normalized(corners[1] - corners[0]), normalized(corners[count - 1] - corners[0]));
  const Real along = dot(normal, ray.direction), ahead = dot(normal, to_corner);
  const Real start = share_of(ahead, length(normal) * length(to_corner));
  Doubts<Real> result;
  if (hit.hit) {
    result.add_root(hit.t, nearest, start);
  } else {
    result.add_miss(along != Real(0) ? ahead / along : Real(0), worst, start);
  }
  return result;
}

template <class Real>
inline Doubts<Real> doubts(const Triangle<Real>& triangle, const Ray<Real>& ray, Departure from) {
  if (from.from_surface()) return {};
  return doubts_of_polygon(triangle.corners, ray,
                           hit_sheared(ShearedRay<Real>(ray), triangle.corners));
}

// The diagonal decides nothing.
template <class Real>
inline Doubts<Real> doubts(const Parallelogram<Real>& quad, const Ray<Real>& ray, Departure from) {
  if (from.from_surface()) return {};
  return doubts_of_polygon(quad.corners, ray, hit_halves(quad, ShearedRay<Real>(ray)).triangle);
}

}  // namespace alhazen::render
