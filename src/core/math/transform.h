// core/math: affine maps between named frames. A variable `b_from_a` takes coordinates in frame a
// and gives coordinates in frame b, so chains read right to left: c_from_b * b_from_a.
#pragma once

#include <array>
#include <optional>

#include "core/math/vec.h"

namespace alhazen {

// p -> M p + t with M the 3x3 matrix of `rows` and t the fourth column.
template <class Real>
struct Affine {
  std::array<std::array<Real, 4>, 3> rows{{{Real(1), Real(0), Real(0), Real(0)},
                                           {Real(0), Real(1), Real(0), Real(0)},
                                           {Real(0), Real(0), Real(1), Real(0)}}};

  Affine() = default;
  explicit Affine(const std::array<std::array<Real, 4>, 3>& r) : rows(r) {}
  template <class Other>
  explicit Affine(const Affine<Other>& other) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j)
        rows[i][j] = static_cast<Real>(other.rows[i][j]);
    }
  }

  Vec3<Real> point(Vec3<Real> p) const {
    return {row(0, p) + rows[0][3], row(1, p) + rows[1][3], row(2, p) + rows[2][3]};
  }
  Vec3<Real> vector(Vec3<Real> v) const { return {row(0, v), row(1, v), row(2, v)}; }
  // M^T v. A normal goes the other way round: world_normal =
  // object_from_world.transposed(n_object), not normalised.
  Vec3<Real> transposed(Vec3<Real> v) const { return {column(0, v), column(1, v), column(2, v)}; }

  friend bool operator==(const Affine& a, const Affine& b) { return a.rows == b.rows; }
  friend Affine operator*(const Affine& c_from_b, const Affine& b_from_a) {
    Affine c_from_a;
    for (int j = 0; j < 4; ++j) {
      const Vec3<Real> b(b_from_a.rows[0][j], b_from_a.rows[1][j], b_from_a.rows[2][j]);
      const Vec3<Real> c = j == 3 ? c_from_b.point(b) : c_from_b.vector(b);
      for (int i = 0; i < 3; ++i)
        c_from_a.rows[i][j] = c[i];
    }
    return c_from_a;
  }

 private:
  Real row(int i, Vec3<Real> v) const {
    return dot(Vec3<Real>(rows[i][0], rows[i][1], rows[i][2]), v);
  }
  Real column(int j, Vec3<Real> v) const {
    return dot(Vec3<Real>(rows[0][j], rows[1][j], rows[2][j]), v);
  }
};

using Affined = Affine<double>;

// The inverse, or nothing when M is singular to working precision: when its determinant is zero,
// not finite, or lost in the rounding of the products that make it.
std::optional<Affined> inverse(const Affined& b_from_a);
double determinant(const Affined& map);

Affined translation(Vec3d offset);
Affined scaling(Vec3d factors);
// Rotation about `axis` (any length but zero) by an angle in degrees, left-handed as POV-Ray: with
// the axis towards the viewer, positive angles turn clockwise on the screen when x is right and y
// up in a left-handed frame. Multiples of 90 degrees are exact about the coordinate axes.
Affined rotation(Vec3d axis, double angle_deg);

}  // namespace alhazen
