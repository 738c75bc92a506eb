// render/shape: boxes that hold every hit a kernel may report.
//
// A hit is the t that crossings() returns for a ray that does not leave the shape itself; its place
// is origin + t direction, exactly. In real arithmetic the place lies on the shape. In Real it lies
// within rounding(kernel) * (|origin| + |shape|) of it, where |.| is the largest absolute
// coordinate. How the kernels come to that, with u the unit roundoff and L = |origin| + |shape|:
//
// - The kernel sees the origin moved to its own centre or frame: an error of 8u L at most in each
//   coordinate, and the direction likewise, 8u |t direction| <= 16u L at the hit.
// - Box: t has two roundings, and t of one slab lies between the t of the others: 2u L.
// - Disc, caps, the height of a frustum: t can be far off where the ray is parallel to the plane,
//   but then along the plane: t d_z = -o_z to 2u, so the distance from the plane is that of the
//   frame, 24u L; within the plane the place itself is compared with the radius.
// - Sphere, side of a cylinder: the discriminant has an error of 8u of its terms, and is at least
//   1/16 of them, or it is of two words: an error of 65u of its root, at most 65u R of length. b
//   has 3u |o||d|, so q / a has 8u |o| + 70u R. c has at most 64u of itself, and the other root,
//   c / q, is not larger than q / a (roots_of sees to it): 72u |o| + 140u R. For a cylinder the
//   lengths are those across the axis, all that counts.
// - Triangle, parallelogram: sheared corners have 4u |corner - origin|, the signs of edge functions
//   are right, weights are positive and add up to 1 within 6u: within 20u L of the corners' hull.
// - Side of a cone: near a generator's direction a = d.d - rho'^2 may cancel and t be far off along
//   the ray. What remains true is that the quadric's value at the hit, x^2 + y^2 - rho^2, is small
//   beside its terms: at most 512u N^2, N = (1 + slope) sqrt(3) L, from 280u for b, the roots and
//   second order, 70u each for a and c. So the distance from the axis is at most rho +
//   sqrt(512u) N; the height is that between the caps.
//
// The figures are rounded up to 256u below, and sqrt(2048u) for cones.
#pragma once

#include "core/math/transform.h"
#include "render/shape/box.h"
#include "render/shape/disc.h"
#include "render/shape/frustum.h"
#include "render/shape/parallelogram.h"
#include "render/shape/sphere.h"
#include "render/shape/triangle.h"

namespace alhazen::render {

// The hits of a ray from `origin` lie between min - reach |origin| and max + reach |origin|, with
// 8u (|origin| + |bounds|) to spare for whoever intersects these bounds in Real.
template <class Real>
struct ShapeBounds {
  Vec3<Real> min, max;
  Real reach;
};

template <class Real>
inline Real largest_coordinate(Vec3<Real> v) {
  return larger(absolute(v.x), larger(absolute(v.y), absolute(v.z)));
}

namespace bounds {

template <class Real>
constexpr Real kU = ScalarTraits<Real>::unit_roundoff();

// A box around an exact surface, to 16u of the numbers that it is made of.
template <class Real>
struct Hull {
  Vec3<Real> min{infinity<Real>(), infinity<Real>(), infinity<Real>()};
  Vec3<Real> max = -min;

  void add(Vec3<Real> point) { add(point, {}); }
  void add(Vec3<Real> center, Vec3<Real> half) {
    for (int i = 0; i < 3; ++i) {
      min[i] = smaller(min[i], center[i] - half[i]);
      max[i] = larger(max[i], center[i] + half[i]);
    }
  }
  Real size() const { return larger(largest_coordinate(min), largest_coordinate(max)); }
};

// How far an ellipsoid with the half-axes a, b, c reaches along the coordinate axes; c = 0: an
// ellipse.
template <class Real>
inline Vec3<Real> reach_of_ellipsoid(Vec3<Real> a, Vec3<Real> b, Vec3<Real> c) {
  return {length(Vec3<Real>(a.x, b.x, c.x)), length(Vec3<Real>(a.y, b.y, c.y)),
          length(Vec3<Real>(a.z, b.z, c.z))};
}

template <class Real>
inline void add_disc(Hull<Real>& hull, const Affine<Real>& map, const Frame<Real>& frame,
                     Vec3<Real> center, Real radius) {
  hull.add(map.point(center),
           radius * reach_of_ellipsoid(map.vector(frame.x), map.vector(frame.y), Vec3<Real>()));
}

// What the affine map makes of a surface that is given in its object frame.
template <class Real>
inline Hull<Real> hull(const Sphere<Real>& sphere, const Affine<Real>& map) {
  Hull<Real> result;
  result.add(map.point(sphere.center),
             sphere.radius * reach_of_ellipsoid(map.vector({Real(1), Real(0), Real(0)}),
                                                map.vector({Real(0), Real(1), Real(0)}),
                                                map.vector({Real(0), Real(0), Real(1)})));
  return result;
}
template <class Real>
inline Hull<Real> hull(const Box<Real>& box, const Affine<Real>& map) {
  Hull<Real> result;
  for (int corner = 0; corner < 8; ++corner) {
    result.add(map.point({corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                          corner & 4 ? box.max.z : box.min.z}));
  }
  return result;
}
template <class Real>
inline Hull<Real> hull(const Disc<Real>& disc, const Affine<Real>& map) {
  Hull<Real> result;
  add_disc(result, map, disc.frame, disc.frame.origin, disc.radius);
  return result;
}
template <class Real>
inline Hull<Real> hull(const Frustum<Real>& frustum, const Affine<Real>& map) {
  Hull<Real> result;
  const Frame<Real>& f = frustum.frame;
  add_disc(result, map, f, f.origin, frustum.small_radius);
  add_disc(result, map, f, multiply_add(frustum.height, f.z, f.origin), frustum.large_radius);
  return result;
}
template <class Real>
inline Hull<Real> hull(const Triangle<Real>& triangle, const Affine<Real>& map) {
  Hull<Real> result;
  for (const Vec3<Real> corner : triangle.corners)
    result.add(map.point(corner));
  return result;
}
template <class Real>
inline Hull<Real> hull(const Parallelogram<Real>& quad, const Affine<Real>& map) {
  Hull<Real> result;
  for (const Vec3<Real> corner : quad.corners)
    result.add(map.point(corner));
  return result;
}

template <class Kernel, class Real>
concept HasHull = requires(const Kernel& kernel, const Affine<Real>& map) {
  hull(kernel, map);
};

// The figure at the head of this file.
template <class Kernel, class Real>
inline Real rounding(const Kernel& kernel) {
  if constexpr (requires { kernel.slope; }) {
    if (kernel.slope > Real(0)) {
      return square_root(Real(2048) * kU<Real>) * (Real(1) + kernel.slope);
    }
  }
  return Real(256) * kU<Real>;
}

template <class Real>
inline ShapeBounds<Real> grown(const Hull<Real>& hull, Real by, Real reach) {
  const Vec3<Real> margin{by, by, by};
  return {hull.min - margin, hull.max + margin, reach};
}

// The largest sum of a row's absolute values: |M v| <= norm(M) |v|.
template <class Real>
inline Real norm(const Affine<Real>& map) {
  Real result = 0;
  for (const auto& row : map.rows)
    result = larger(result, absolute(row[0]) + absolute(row[1]) + absolute(row[2]));
  return result;
}
template <class Real>
inline Real shift(const Affine<Real>& map) {
  return largest_coordinate(map.point(Vec3<Real>()));
}

}  // namespace bounds

// Of a kernel in the frame of the rays, whose hull is known.
template <class Real, class Kernel>
inline ShapeBounds<Real> bounds_around(const Kernel& kernel, const bounds::Hull<Real>& hull) {
  // 32u: the hull's own roundings and those to spare.
  const Real reach = bounds::rounding<Kernel, Real>(kernel) + Real(32) * bounds::kU<Real>;
  return bounds::grown(hull, reach * hull.size(), reach);
}
template <class Real, class Kernel>
inline ShapeBounds<Real> bounds_in_world(const Kernel& kernel) {
  return bounds_around<Real>(kernel, bounds::hull(kernel, Affine<Real>()));
}

namespace bounds {

// Of something in an object frame that rays are mapped to. `there` is what world_from_object makes
// of it, its hits in that frame lie within kernel_error (|origin| + object_size) of it. The two
// maps are inverse only to rounding: with E = object_from_world * world_from_object - 1, a point p
// whose image is q lies where world_from_object puts q but for the inverse's norm times E q, and
// that norm is at most twice the norm of world_from_object if E < 1/2. If not, or if a number
// leaves the range of Real, the result is not finite.
template <class Real>
inline ShapeBounds<Real> placed(const Hull<Real>& there, Real object_size, Real kernel_error,
                                const Affine<Real>& world_from_object,
                                const Affine<Real>& object_from_world) {
  const Real u = kU<Real>, in = norm(object_from_world), out = norm(world_from_object);
  Affine<Real> error = object_from_world * world_from_object;
  for (int i = 0; i < 3; ++i)
    error.rows[i][i] -= Real(1);
  const Real out_shift = shift(world_from_object), in_shift = shift(object_from_world);
  const Real twist = norm(error) + Real(16) * u * in * out;
  const Real slip = shift(error) + Real(16) * u * (in * out_shift + in_shift);
  if (!(twist < Real(0.5))) return grown(there, infinity<Real>(), infinity<Real>());
  const Real size = there.size();
  // In the object frame, beside what grows with |origin|: the kernel's error, and that of the
  // mapped origin and direction, 16u of |object_from_world| (|origin| + |shape|) each.
  const Real in_object = kernel_error * (in_shift + object_size) +
                         Real(32) * u * (in * size + in_shift) + twist * object_size + slip;
  const Real in_world =
      Real(2) * out * in_object + Real(32) * u * (size + out * object_size + out_shift);
  const Real reach = Real(2) * out * in * (kernel_error + Real(32) * u) + Real(32) * u;
  return grown(there, in_world, reach);
}

}  // namespace bounds

// Of a kernel that has the ray mapped to its object frame.
template <class Real, class Kernel>
inline ShapeBounds<Real> bounds_in_world(const Kernel& kernel,
                                         const Affine<Real>& world_from_object,
                                         const Affine<Real>& object_from_world) {
  return bounds::placed(
      bounds::hull(kernel, world_from_object), bounds::hull(kernel, Affine<Real>()).size(),
      bounds::rounding<Kernel, Real>(kernel), world_from_object, object_from_world);
}

// Of shapes with bounds of their own in a frame that rays are mapped to.
template <class Real>
inline ShapeBounds<Real> bounds_in_world(const ShapeBounds<Real>& own,
                                         const Affine<Real>& world_from_group,
                                         const Affine<Real>& group_from_world) {
  const Box<Real> box{own.min, own.max};
  return bounds::placed(bounds::hull(box, world_from_group),
                        bounds::hull(box, Affine<Real>()).size(), own.reach, world_from_group,
                        group_from_world);
}

}  // namespace alhazen::render
