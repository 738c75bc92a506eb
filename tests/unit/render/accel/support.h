// Scenes and rays that are hard on a tree of boxes.
#pragma once

#include <gtest/gtest.h>

#include "render/accel/hit.h"
#include "unit/render/shape/support.h"

namespace alhazen::render {

template <class Real>
void expect_same(const std::optional<Hit<Real>>& found, const std::optional<Hit<Real>>& expected) {
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) return;
  EXPECT_TRUE(found->t == expected->t);
  EXPECT_EQ(found->shape, expected->shape);
  EXPECT_EQ(found->face, expected->face);
  EXPECT_EQ(found->enters, expected->enters);
}

// `count` times every kind, over six decades of sizes, a third of them with a transform.
inline std::vector<Shape> mixed_shapes(std::uint64_t seed, double scale, int count) {
  Dice dice(seed);
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) {
    const double size = scale * std::pow(10, dice.uniform(-5, 0.5));
    const Vec3d at = scale * dice.in_cube(4), n = dice.direction();
    const Vec3d a = size * dice.in_cube(1), b = size * dice.in_cube(1), c = size * dice.in_cube(1);
    const Vec3d top = at + size * dice.direction();
    const double wide = size * dice.uniform(0.05, 1), narrow = wide * dice.uniform(0, 1);
    std::vector<Geometry> kinds = {alhazen::Sphere{at, wide},
                                   alhazen::Box{at, at + Vec3d{wide, narrow + 0.01 * wide, size}},
                                   Cylinder{at, top, wide, i % 2 == 0},
                                   Cone{at, top, wide, i % 3 == 0 ? 0 : narrow, i % 2 == 0},
                                   alhazen::Disc{at, n, wide, i % 2 == 0 ? 0 : 0.5 * wide},
                                   alhazen::Triangle{{at + a, at + b, at + c}, {}},
                                   Quad4{at, a, b}};
    for (const Geometry& geometry : kinds) {
      Shape shape = shape_of(geometry);
      if (dice.below(3) == 0) {
        const Affined stretch =
            scaling({dice.uniform(0.1, 2), -dice.uniform(0.1, 2), dice.uniform(0.001, 2)});
        shape.world_from_object = translation(scale * dice.in_cube(1)) *
                                  rotation(dice.direction(), dice.uniform(0, 360)) * stretch *
                                  rotation(dice.direction(), dice.uniform(0, 360));
      }
      shapes.push_back(shape);
    }
    if (i == 0) shapes.push_back(shape_of(alhazen::Plane{n, -3 * scale}));
  }
  return shapes;
}

// A 4x4x4 grid of unit boxes that share their faces, each there twice, and spheres, discs and
// triangles at one place.
inline std::vector<Shape> coincident_shapes(double scale) {
  std::vector<Shape> shapes;
  for (int copy = 0; copy < 2; ++copy) {
    for (int x = -2; x < 2; ++x) {
      for (int y = -2; y < 2; ++y) {
        for (int z = -2; z < 2; ++z) {
          const Vec3d corner{double(x), double(y), double(z)};
          shapes.push_back(
              shape_of(alhazen::Box{scale * corner, scale * (corner + Vec3d{1, 1, 1})}));
        }
      }
    }
  }
  const Vec3d z{0, 0, 2 * scale};
  for (int i = 0; i < 20; ++i) {
    shapes.push_back(shape_of(alhazen::Sphere{{}, scale}));
    shapes.push_back(shape_of(alhazen::Disc{z, {0, 0, 1}, 2 * scale, 0}));
    shapes.push_back(
        shape_of(alhazen::Triangle{{z, z + Vec3d{scale, 0, 0}, z + Vec3d{0, scale, 0}}, {}}));
    shapes.push_back(shape_of(Cylinder{{}, z, 2 * scale, true}));
  }
  return shapes;
}

// From anywhere in the scene to anywhere; a quarter of them along an axis.
template <class Real>
Ray<Real> random_ray(Dice& dice, double scale) {
  const Vec3d from = scale * dice.in_cube(5);
  Vec3d direction = dice.direction();
  if (dice.below(4) == 0) {
    direction = {};
    direction[dice.below(3)] = dice.below(2) == 0 ? 1 : -1;
  }
  return {Vec3<Real>(from), Vec3<Real>(direction)};
}

// Between points of the half-integer lattice: along faces, edges and diagonals, from faces' planes.
template <class Real>
Ray<Real> lattice_ray(Dice& dice, double scale) {
  const auto half_integers = [&dice](int most) {
    return Vec3d{0.5 * (dice.below(2 * most + 1) - most), 0.5 * (dice.below(2 * most + 1) - most),
                 0.5 * (dice.below(2 * most + 1) - most)};
  };
  for (;;) {
    const Vec3d direction = half_integers(4);
    if (direction == Vec3d()) continue;
    return {Vec3<Real>(scale * half_integers(8)), Vec3<Real>(direction)};
  }
}

// From `distance` away towards the shape's box, to a point in it, or on its face or edge, or a
// little beside it.
template <class Real>
Ray<Real> grazing_ray(Dice& dice, const ShapeBounds<Real>& bounds, double distance) {
  Vec3<Real> target;
  for (int axis = 0; axis < 3; ++axis) {
    const Real part = dice.below(3) == 0 ? static_cast<Real>(dice.below(2))
                                         : static_cast<Real>(dice.uniform(-0.01, 1.01));
    target[axis] = bounds.min[axis] + part * (bounds.max[axis] - bounds.min[axis]);
  }
  Vec3d away = dice.direction();
  if (dice.below(3) == 0) {
    away = {};
    away[dice.below(3)] = dice.below(2) == 0 ? 1 : -1;
  }
  const Vec3<Real> origin = target + Vec3<Real>(distance * away);
  return {origin, normalized(Vec3<Real>(-away))};
}

// Along a line of the side, or a parallel of it, from up to 10^4 away.
template <class Real>
Ray<Real> ray_along_side(Dice& dice, const Cone& cone) {
  const Vec3d axis = cone.top - cone.base;
  const Vec3d across = normalized(cross(axis, dice.direction()));
  const Vec3d low = cone.base + cone.base_radius * across;
  const Vec3d high = cone.top + cone.top_radius * across;
  const Vec3d along = normalized(high - low);
  const double beside = dice.below(2) == 0 ? 0 : std::pow(10, dice.uniform(-18, 0));
  const double back = std::pow(10, dice.uniform(0, 4));
  const Vec3d from = low + beside * dice.direction() - back * along;
  return {Vec3<Real>(from), Vec3<Real>(along)};
}

}  // namespace alhazen::render
