// render/shape: the box with faces along the axes. Faces: 0 -x, 1 +x, 2 -y, 3 +y, 4 -z, 5 +z.
//
// Slabs (Kay and Kajiya 1986) with divisions instead of reciprocals, so that t is rounded twice
// only, and without 0 * infinity: an axis along which the ray does not move is decided by its
// origin. u and v run over [0, 1] along the face's two other axes, in the order x, y, z.
#pragma once

#include <tuple>

#include "render/shape/span.h"

namespace alhazen::render {

template <class Real>
struct Box {
  Vec3<Real> min, max;

  static auto fields(auto& box) { return std::tie(box.min, box.max); }
};

template <class Real>
inline Span<Real> span_in(const Box<Real>& box, const Ray<Real>& ray) {
  using Int = IntOf<Real>;
  Span<Real> span;
  for (int axis = 0; axis < 3; ++axis) {
    const Real o = ray.origin[axis], d = ray.direction[axis];
    const Real min = box.min[axis], max = box.max[axis];
    const Int lower(2 * axis), upper(2 * axis + 1);
    const MaskOf<Real> up = d > Real(0), moves = up || d < Real(0);
    if (any(moves)) {
      span.cut((select(up, min, max) - o) / d, select(up, lower, upper),
               (select(up, max, min) - o) / d, select(up, upper, lower), moves);
    }
    span.empty = span.empty || (!moves && !(min <= o && o <= max));
  }
  return span;
}

template <class Real>
inline CrossingPair<Real> crossings(const Box<Real>& box, const Ray<Real>& ray) {
  return ends_of(span_in(box, ray));
}

template <class Real>
inline CrossingPair<Real> own_crossings(const Box<Real>& box, const Ray<Real>& ray,
                                        const OwnDeparture<Real>& from) {
  using Int = IntOf<Real>;
  const Vec3<Real> d = ray.direction;
  const Int axis = from.face >> 1;
  const Real along = select(axis == Int(0), d.x, select(axis == Int(1), d.y, d.z));
  const MaskOf<Real> lower = (from.face & Int(1)) == Int(0);
  const MaskOf<Real> inward = goes_below(from, select(lower, -along, along));
  if (!any(inward)) return {};
  return exit_of(span_in(box, ray), inward);
}

template <bool with_coordinates = true, class Real>
inline Surface<Real> surface(const Box<Real>& box, const Ray<Real>& ray,
                             const Crossing<Real>& crossing) {
  using Int = IntOf<Real>;
  const Int axis = crossing.face >> 1;
  const MaskOf<Real> upper = (crossing.face & Int(1)) == Int(1);
  Vec3<Real> position = ray.at(crossing.t), normal;
  for (int i = 0; i < 3; ++i) {
    const MaskOf<Real> across = axis == Int(i);
    const Real within = smaller(larger(position[i], box.min[i]), box.max[i]);
    position[i] = select(across, select(upper, box.max[i], box.min[i]), within);
    normal[i] = select(across, select(upper, Real(1), Real(-1)), Real(0));
  }
  if constexpr (!with_coordinates) return {position, normal, normal};
  const auto along = [&](int i) { return (position[i] - box.min[i]) / (box.max[i] - box.min[i]); };
  const Real middle = along(1);
  return {position, normal, normal, select(axis == Int(0), middle, along(0)),
          select(axis == Int(2), middle, along(2))};
}

template <class Real>
inline bool contains(const Box<Real>& box, Vec3<Real> point) {
  for (int i = 0; i < 3; ++i) {
    if (!(box.min[i] < point[i] && point[i] < box.max[i])) return false;
  }
  return true;
}

}  // namespace alhazen::render
