// tests/hard/kernels: one shape of every kind, at random, and the ways in which answers can differ.
#pragma once

#include "hard/kernels/support.h"

namespace alhazen::hard {

using render::random_solids;
using render::shape_of;
using render::ShapeTable;

// The closed solids first. The same dice and scales by powers of two give the same shapes, scaled.
inline std::vector<Geometry> every_kind(Dice& dice, double scale) {
  std::vector<Geometry> kinds = random_solids(dice, scale);
  const Vec3d axis = scale * dice.direction(), normal = dice.direction();
  const Vec3d a = scale * dice.in_cube(2), b = scale * dice.in_cube(2), c = scale * dice.in_cube(2);
  kinds.push_back(Cylinder{scale * dice.in_cube(1), 3.0 * axis, scale, false});
  kinds.push_back(Cone{{}, axis, scale, 0.25 * scale, false});
  kinds.push_back(alhazen::Plane{normal, 0.5 * scale});
  kinds.push_back(alhazen::Disc{{}, normal, 2 * scale, 0.5 * scale});
  kinds.push_back(alhazen::Triangle{{a, b, c}, {}});
  kinds.push_back(Quad4{a, b, c});
  return kinds;
}

inline std::vector<Shape> shapes_of(const std::vector<Geometry>& geometries) {
  std::vector<Shape> shapes;
  for (const Geometry& geometry : geometries)
    shapes.push_back(shape_of(geometry));
  return shapes;
}

// Whether both are the same crossings, those of `b` with every t times `scale`, to the last bit.
template <class Real>
bool same_bits(const Crossings<Real>& a, const Crossings<Real>& b, Real scale = Real(1)) {
  if (a.size() != b.size()) return false;
  for (int i = 0; i < a.size(); ++i) {
    if (a[i].t != b[i].t * scale || a[i].face != b[i].face || a[i].enters != b[i].enters)
      return false;
  }
  return true;
}

}  // namespace alhazen::hard
