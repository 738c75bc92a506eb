// render/shape: a few points and lengths that say where a shape is, so that shapes which were
// described in two ways, or placed by two maps, can be compared.
#pragma once

#include <array>

#include "render/shape/kernel_arrays.h"

namespace alhazen::render {

// In the world frame of the table. Two shapes of one form are one surface, face by face, if and
// only if these numbers are the same.
template <class Real>
struct Landmarks {
  int form = 0;                    // of what kind, capped or not, which way round, how described
  std::array<Real, 13> lengths{};  // coordinates of points, then lengths
  int used = 0;                    // of them; the others are 0
  Vec3<Real> direction;            // of unit length; of a plane alone
  Real size = 0;                   // of the shape; infinite of a plane

  // The first point is the one that the size is measured from.
  void add_point(Vec3<Real> p) {
    for (int axis = 0; axis < 3; ++axis) {
      lengths[used] = p[axis];
      if (used >= 3) size = larger(size, absolute(p[axis] - lengths[used % 3]));
      ++used;
    }
  }
  void add_length(Real length) {
    lengths[used++] = length;
    size = larger(size, length);
  }
};

namespace landmarks {

// How an object frame lies in the world. Maps that keep angles keep a ball a ball however they turn
// it, and a cylinder round.
template <class Real>
struct Place {
  const Placement<Real>* placement = nullptr;  // none: the frame is the world
  Real scale = Real(1);                        // of lengths, where angles are kept
  bool keeps_angles = true;

  Place() = default;
  explicit Place(const Placement<Real>& p) : placement(&p) {
    const auto& rows = p.world_from_object.rows;
    std::array<Vec3<Real>, 3> columns;
    for (int j = 0; j < 3; ++j)
      columns[j] = {rows[0][j], rows[1][j], rows[2][j]};
    scale = length(columns[0]);
    // A product of two rotations that were rounded is one to less than this.
    const Real rounding = Real(32) * ScalarTraits<Real>::unit_roundoff() * scale;
    for (int j = 0; j < 3; ++j) {
      const Vec3<Real>&a = columns[j], &b = columns[(j + 1) % 3];
      keeps_angles = keeps_angles && absolute(dot(a, b)) <= rounding * scale &&
                     absolute(length(b) - scale) <= rounding;
    }
  }

  Vec3<Real> point(Vec3<Real> p) const {
    return placement == nullptr ? p : placement->world_from_object.point(p);
  }
  Real length_along(Vec3<Real> v) const {
    return placement == nullptr ? length(v) : length(placement->world_from_object.vector(v));
  }
};

// Each puts down what it needs, and says in `form` which way of the kind's it took.

template <class Real>
inline void put(Landmarks<Real>& marks, const Sphere<Real>& s, const Place<Real>& place) {
  marks.add_point(place.point(s.center));
  if (place.keeps_angles) {
    marks.add_length(s.radius * place.scale);
    return;
  }
  marks.form = 1;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<Real> p = s.center;
    p[axis] += s.radius;
    marks.add_point(place.point(p));
  }
}

template <class Real>
inline void put(Landmarks<Real>& marks, const Box<Real>& b, const Place<Real>& place) {
  marks.add_point(place.point(b.min));
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<Real> corner = b.min;
    corner[axis] = b.max[axis];
    marks.add_point(place.point(corner));
  }
}

template <class Real>
inline void put(Landmarks<Real>& marks, const Disc<Real>& d, const Place<Real>& place) {
  const auto& [o, x, y, z] = d.frame;
  marks.add_point(place.point(o));
  if (place.keeps_angles) {
    marks.add_point(place.point(multiply_add(d.radius, z, o)));
    marks.add_length(d.radius * place.scale);
    marks.add_length(d.hole_radius * place.scale);
    return;
  }
  marks.form = 1;
  marks.add_point(place.point(multiply_add(d.radius, x, o)));
  marks.add_point(place.point(multiply_add(d.radius, y, o)));
  marks.add_point(place.point(multiply_add(d.hole_radius, x, o)));
}

template <class Real>
inline void put(Landmarks<Real>& marks, const Frustum<Real>& f, const Place<Real>& place) {
  const auto& [o, x, y, z] = f.frame;
  const Vec3<Real> end = multiply_add(f.height, z, o);
  marks.form = (f.capped ? 1 : 0) + (place.keeps_angles ? 0 : 2);
  marks.add_point(place.point(o));
  marks.add_point(place.point(end));
  if (place.keeps_angles) {
    marks.add_length(f.small_radius * place.scale);
    marks.add_length(f.large_radius * place.scale);
    return;
  }
  marks.add_point(place.point(multiply_add(f.large_radius, x, end)));
  marks.add_point(place.point(multiply_add(f.large_radius, y, end)));
  marks.add_length(place.length_along(f.small_radius * x));
}

// These kinds are in the world frame already.
template <class Real>
inline void put(Landmarks<Real>& marks, const Plane<Real>& p, const Place<Real>& /*place*/) {
  marks.add_length(p.offset);
  marks.direction = p.normal;
  marks.size = infinity<Real>();
}
template <class Real>
inline void put(Landmarks<Real>& marks, const Triangle<Real>& t, const Place<Real>& /*place*/) {
  marks.form = t.reversed ? 1 : 0;
  for (const Vec3<Real>& corner : t.corners)
    marks.add_point(corner);
}
template <class Real>
inline void put(Landmarks<Real>& marks, const Parallelogram<Real>& q,
                const Place<Real>& /*place*/) {
  marks.form = q.reversed ? 1 : 0;
  for (const int k : {0, 1, 3})
    marks.add_point(q.corners[k]);
}

}  // namespace landmarks

}  // namespace alhazen::render
