// render/shape: the box with faces along the axes. Faces: 0 -x, 1 +x, 2 -y, 3 +y, 4 -z, 5 +z.
//
// Slabs (Kay and Kajiya 1986) with divisions instead of reciprocals, so that t is rounded twice
// only, and without 0 * infinity: an axis along which the ray does not move is decided by its
// origin. u and v run over [0, 1] along the face's two other axes, in the order x, y, z.
#pragma once

#include "render/shape/crossing.h"

namespace alhazen::render {

template <class Real>
struct Box {
  Vec3<Real> min, max;
};

template <class Real>
inline Span<Real> span_in(const Box<Real>& box, const Ray<Real>& ray) {
  Span<Real> span;
  for (int axis = 0; axis < 3; ++axis) {
    const Real o = ray.origin[axis], d = ray.direction[axis];
    const Real min = box.min[axis], max = box.max[axis];
    if (d > Real(0)) {
      span.cut((min - o) / d, 2 * axis, (max - o) / d, 2 * axis + 1);
    } else if (d < Real(0)) {
      span.cut((max - o) / d, 2 * axis + 1, (min - o) / d, 2 * axis);
    } else if (!(min <= o && o <= max)) {
      span.empty = true;
    }
  }
  return span;
}

template <class Real>
inline Crossings<Real> crossings(const Box<Real>& box, const Ray<Real>& ray, Departure from) {
  const Span<Real> span = span_in(box, ray);
  if (!from.from_surface()) return ends_of(span);
  const Real d = ray.direction[from.face / 2];
  return goes_below(from, from.face % 2 == 0 ? -d : d) ? exit_of(span) : Crossings<Real>();
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Box<Real>& box, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  const int axis = crossing.face / 2;
  const bool upper = crossing.face % 2 == 1;
  Vec3<Real> position = ray.at(crossing.t), normal;
  for (int i = 0; i < 3; ++i)
    position[i] = smaller(larger(position[i], box.min[i]), box.max[i]);
  position[axis] = upper ? box.max[axis] : box.min[axis];
  normal[axis] = upper ? Real(1) : Real(-1);
  const int u_axis = axis == 0 ? 1 : 0, v_axis = axis == 2 ? 1 : 2;
  const auto along = [&](int i) { return (position[i] - box.min[i]) / (box.max[i] - box.min[i]); };
  return {position, normal, normal, along(u_axis), along(v_axis)};
}

template <class Real>
inline bool contains(const Box<Real>& box, Vec3<Real> point) {
  for (int i = 0; i < 3; ++i) {
    if (!(box.min[i] < point[i] && point[i] < box.max[i])) return false;
  }
  return true;
}

}  // namespace alhazen::render
