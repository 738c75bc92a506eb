// Quads and discs in the plane of something else: which of the two a ray meets is a rule, from
// every direction, at every scale and turn.
#include <gtest/gtest.h>

#include "render/accel/closest_hit.h"
#include "render/accel/shape_tree.h"
#include "unit/render/accel/support.h"

namespace alhazen::render {
namespace {

constexpr double kScales[] = {0x1p-300, 1, 0x1p300};

Shape lamp_of(const Geometry& geometry) {
  Shape shape = shape_of(geometry);
  shape.light = 0;
  return shape;
}

// A unit box, scaled and turned, with shapes that are given beside the unit box.
std::vector<Shape> turned(std::vector<Shape> shapes, double scale, double angle_deg) {
  for (Shape& shape : shapes) {
    shape.world_from_object =
        rotation({1, 2, -2}, angle_deg) * scaling({scale, scale, scale}) * translation({2, 1, 3});
  }
  return shapes;
}

// Of rays from outside of a turned unit box to points (x, 1, z) of its top with x and z within
// `within` of the middle, those that do not meet `expected` first, or that meet something on the
// way back.
template <class Real>
int wrong_on_top(const std::vector<Shape>& shapes, double scale, double angle_deg, double within,
                 ShapeId expected) {
  const std::vector<Shape> all = turned(shapes, scale, angle_deg);
  const ShapeTable<Real> table(all, {});
  const ShapeTree<Real> tree(table);
  const Affined& place = *all[0].world_from_object;
  Dice dice(91);
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d at{0.5 + dice.uniform(-within, within), 1, 0.5 + dice.uniform(-within, within)};
    const Vec3d from = at + Vec3d{dice.uniform(-3, 3), dice.uniform(0.01, 3), dice.uniform(-3, 3)};
    const Vec3<Real> start(place.point(from)), end(place.point(at));
    const Vec3<Real> direction = normalized(end - start);
    const Ray<Real> ray{start, direction};
    const auto hit = closest_hit(tree, ray, Source(), infinity<Real>());
    if (!hit || hit->shape != expected) {
      ++wrong;
      continue;
    }
    const Ray<Real> back{table.plain_surface(hit->shape, ray, hit->crossing()).position,
                         -direction};
    const Source source{hit->shape, hit->face, hit->enters ? Side::kAbove : Side::kBelow,
                        Vec3d(direction)};
    wrong += any_hit(tree, back, source, infinity<Real>()) ? 1 : 0;
  }
  return wrong;
}

template <class Real>
void expect_on_top(const std::vector<Shape>& shapes, double within, ShapeId expected) {
  for (const double scale : kScales) {
    if (sizeof(Real) < sizeof(double) && scale != 1) continue;
    for (const double angle_deg : {0.0, 17.0, 33.3, 123.4}) {
      EXPECT_EQ(wrong_on_top<Real>(shapes, scale, angle_deg, within, expected), 0)
          << "scale " << scale << " turned by " << angle_deg;
    }
  }
}
void expect_on_top(const std::vector<Shape>& shapes, double within, ShapeId expected) {
  expect_on_top<double>(shapes, within, expected);
  expect_on_top<float>(shapes, within, expected);
}

const Shape kBox = shape_of(alhazen::Box{{0, 0, 0}, {1, 1, 1}});
const Shape kRug = shape_of(Quad4{{0.2, 1, 0.2}, {0, 0, 0.6}, {0.6, 0, 0}});
const Shape kMat = shape_of(alhazen::Disc{{0.5, 1, 0.5}, {0, 1, 0}, 0.25, 0});

TEST(Laid, SheetsLieOnTheOutsideOfSolids) {
  expect_on_top({kBox, kRug}, 0.29, 1);
  expect_on_top({kRug, kBox}, 0.29, 0);
  expect_on_top({kBox, kMat}, 0.17, 1);
  expect_on_top({shape_of(Cylinder{{0.5, 0, 0.5}, {0.5, 1, 0.5}, 0.5, true}), kRug}, 0.29, 1);
  expect_on_top({shape_of(Cone{{0.5, 0, 0.5}, {0.5, 1, 0.5}, 0.1, 0.7, true}), kRug}, 0.29, 1);
  expect_on_top({shape_of(alhazen::Plane{{0, 1, 0}, 1}), kRug}, 0.29, 1);
}

// In float the lift is 6e-5, and rays that come at 0.2 degrees pass over the last 0.02 of a rug.
TEST(Laid, TheLaterLiesOnTheEarlier) {
  expect_on_top({kBox, kRug, kMat}, 0.15, 2);
  expect_on_top({kBox, kMat, kRug}, 0.27, 2);
  expect_on_top({kMat, kRug, kBox}, 0.27, 1);
}

// edge_u x edge_v is up: that is the side which shines.
TEST(Laid, LampsLieOnAnything) {
  const Shape lamp = lamp_of(Quad4{{0.2, 1, 0.2}, {0, 0, 0.6}, {0.6, 0, 0}});
  const Shape sheet = shape_of(Quad4{{-1, 1, -1}, {3, 0, 0}, {0, 0, 3}});
  expect_on_top({kBox, lamp}, 0.29, 1);
  expect_on_top({sheet, lamp}, 0.29, 1);
  expect_on_top({lamp, sheet}, 0.29, 0);
}

template <class Real>
bool is_lifted(const std::vector<Shape>& shapes, ShapeId id) {
  return ShapeTable<Real>(shapes, {}).lift(id) != Vec3<Real>();
}

TEST(Laid, WhatLiesOnNothingStaysWhereItIs) {
  const auto quad = [](Vec3d corner, Vec3d u, Vec3d v) { return shape_of(Quad4{corner, u, v}); };
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const std::vector<std::vector<Shape>> none = {
      {kBox, quad({1, 1, 0}, x, z)},                     // beside it
      {kBox, quad({0, 1, 0.5}, x, y)},                   // stands on it
      {kBox, quad({0, 1 + 1e-12, 0}, x, z)},             // above it
      {kBox, quad({0, 1, 0}, x, z + 1e-12 * y)},         // not quite parallel
      {quad({0, 0, 0}, x, z), quad({0.5, 0, 0}, x, z)},  // no solid
      {kBox, quad({3, 1, 3}, x, z)}};
  for (std::size_t i = 0; i < none.size(); ++i)
    EXPECT_FALSE(is_lifted<double>(none[i], 1)) << i;
  EXPECT_TRUE(is_lifted<double>({kBox, kRug}, 1));
  EXPECT_FALSE(is_lifted<double>({kBox, kRug}, 0));
}

// 512 roundings of its largest coordinate, along the normal; twice that for what lies on it.
TEST(Laid, ByMultiplesOfRoundings) {
  const ShapeTable<double> table({kBox, kRug, kMat}, {});
  EXPECT_EQ(table.lift(1), (Vec3d{0, 512 * 0x1p-53, 0}));
  EXPECT_EQ(table.lift(2), (Vec3d{0, 2 * 512 * 0x1p-53, 0}));
}

// A carpet is farther away than what lies on it, and what lies on it is above it all the same.
TEST(Laid, OnLargerSheetsToo) {
  const Shape floor = shape_of(alhazen::Box{{-50, 0, -50}, {50, 1, 50}});
  const Shape carpet = shape_of(Quad4{{-20, 1, -20}, {0, 0, 40}, {40, 0, 0}});
  expect_on_top<double>({floor, carpet, kRug, kMat}, 0.17, 3);
  expect_on_top<double>({floor, carpet, kMat, kRug}, 0.29, 3);
}

TEST(Laid, LampsLieOnPanelsWhoeverIsFirst) {
  const Shape lamp = lamp_of(Quad4{{0.2, 1, 0.2}, {0, 0, 0.6}, {0.6, 0, 0}});
  const Shape panel = shape_of(Quad4{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}});
  expect_on_top<double>({kBox, lamp, panel}, 0.29, 1);
  expect_on_top<double>({lamp, panel, kBox}, 0.29, 0);
}

// As high as a lamp that is seen.
TEST(Laid, LampsThatAreNoShapes) {
  const Shape panel = shape_of(Quad4{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}});
  const Vec3d u{0, 0, 0.6}, v{0.6, 0, 0}, corner{0.2, 1, 0.2};
  const ShapeTable<double> seen({kBox, panel, lamp_of(Quad4{corner, u, v})}, {});
  const ShapeTable<double> table({kBox, panel}, {});
  const std::array<Vec3d, 4> corners{corner, corner + u, corner + u + v, corner + v};
  EXPECT_EQ(table.lift_of_lamp(corners), seen.lift(2));
  EXPECT_EQ(table.lift_of_lamp(corners), 2.0 * table.lift(1));
  std::array<Vec3d, 4> below = corners;
  for (Vec3d& c : below)
    c.y -= 0.5;
  EXPECT_EQ(table.lift_of_lamp(below), Vec3d());
}

// Tiles touch and do not lie on each other, however many there are and however they are turned.
TEST(Laid, TilesAreAllOnOneLevel) {
  for (const double angle_deg : {0.0, 17.0, 45.0}) {
    const Affined turn = rotation({0, 1, 0}, angle_deg);
    std::vector<Shape> shapes = {shape_of(alhazen::Plane{{0, 1, 0}, 0})};
    for (int i = 0; i < 30; ++i) {
      for (int k = 0; k < 30; ++k) {
        shapes.push_back(shape_of(Quad4{turn.point({0.1 * i, 0, 0.1 * k}), turn.vector({0, 0, 0.1}),
                                        turn.vector({0.1, 0, 0})}));
      }
    }
    const ShapeTable<double> table(shapes, {});
    for (ShapeId id = 1; id < table.size(); ++id) {
      EXPECT_GT(table.lift(id).y, 0);
      EXPECT_LE(table.lift(id).y, 512 * 0x1p-53 * 4.3);  // the largest coordinate
    }
  }
}

}  // namespace
}  // namespace alhazen::render
