// render/accel: the way of a ray, or of lanes of rays, up to the nodes of a tree (tree_ray.h).
#pragma once

#include "render/accel/tree_ray.h"
#include "render/shape/bounds.h"

namespace alhazen::render {

template <class Real>
inline Vec3<TreeNumberOf<Real>> to_tree(Vec3<Real> v) {
  return {to_tree(v.x), to_tree(v.y), to_tree(v.z)};
}

// What a tree knows of itself for this. The boxes hold the hits of rays that start no farther than
// start_radius from the origin in any coordinate if they are grown by near_reach |origin|; else by
// far_reach |origin|.
template <class Real>
struct TreeFrame {
  Real start_radius = 0, near_reach = 0, far_reach = 0;
  Real units = 0;       // of the tree in a length of the scene
  Vec3<Real> min, max;  // of all boxes
};

template <class L>
struct Approach {
  using Float = TreeNumberOf<L>;

  MaskOf<L> lost;    // nothing can be said of this ray: it has to be tested against every shape
  MaskOf<L> enters;  // the others that come within the box around all
  TreeClock<L> clock;
  Vec3<Float> origin, inverse;  // in the units of the tree
  Float blur;                   // the margin of the kernels, in these units
};

// Whether the error bounds speak of this ray.
template <class L>
inline MaskOf<L> is_ordinary(const Ray<L>& ray) {
  using Real = ScalarOf<L>;
  const L speed = largest_coordinate(ray.direction);
  return speed >= L(Real(1) / largest_ordinary<Real>()) && speed <= L(largest_ordinary<Real>()) &&
         largest_coordinate(ray.origin) <= L(largest_ordinary<Real>());
}

// Of the part of the ray from `from` to `to`.
template <class L>
inline Approach<L> approach(const TreeFrame<ScalarOf<L>>& frame, const Ray<L>& ray, L from, L to) {
  using Real = ScalarOf<L>;
  const L distance = largest_coordinate(ray.origin);
  const L margin =
      select(distance <= L(frame.start_radius), L(frame.near_reach), L(frame.far_reach)) * distance;
  const TreeSpan<L> span = span_in(Vec3<L>(frame.min), Vec3<L>(frame.max), ray, margin, from, to);
  const L speed = largest_coordinate(ray.direction), blur = L(frame.units) * margin;
  const Vec3<L> start = L(frame.units) * ray.at(span.near);
  Approach<L> result;
  const MaskOf<L> ordinary = is_ordinary(ray), comes = !(span.near > span.far);
  // From so far away that it is blurred as much, any box is as likely as another.
  const MaskOf<L> sharp = blur <= L(Real(1));
  result.lost = !ordinary || (comes && !sharp);
  result.enters = ordinary && comes && sharp;
  result.clock = {span.near, speed * L(frame.units)};
  result.origin = to_tree(start);
  result.inverse = to_tree(speed * span.reciprocal);
  result.blur = to_tree(blur);
  return result;
}

}  // namespace alhazen::render
