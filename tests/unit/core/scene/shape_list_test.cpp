// Shapes come back from their list as they went in.
#include "core/scene/shape_list.h"

#include <gtest/gtest.h>

namespace alhazen {
namespace {

// One of each kind, the k-th with k in its numbers.
std::vector<Geometry> geometries(double k) {
  const Vec3d a{k, 1, 2}, b{k + 3, 4, 5}, c{k, 7, 9};
  return {Sphere{a, k + 1},
          Plane{{0, 1, 0}, k},
          Box{a, b},
          Disc{a, {0, 0, 1}, 2, k},
          Cylinder{a, b, k, false},
          Cone{a, b, k, 3, true},
          Triangle{{a, b, c}, {}},
          Quad4{a, b, c}};
}

bool same(const Geometry& a, const Geometry& b) {
  if (a.index() != b.index()) return false;
  if (const auto* s = std::get_if<Sphere>(&a)) {
    return s->center == std::get<Sphere>(b).center && s->radius == std::get<Sphere>(b).radius;
  }
  if (const auto* s = std::get_if<Plane>(&a)) return s->offset == std::get<Plane>(b).offset;
  if (const auto* s = std::get_if<Box>(&a)) return s->max == std::get<Box>(b).max;
  if (const auto* s = std::get_if<Disc>(&a)) return s->hole_radius == std::get<Disc>(b).hole_radius;
  if (const auto* s = std::get_if<Cylinder>(&a)) return s->radius == std::get<Cylinder>(b).radius;
  if (const auto* s = std::get_if<Cone>(&a)) return s->base_radius == std::get<Cone>(b).base_radius;
  if (const auto* s = std::get_if<Triangle>(&a)) {
    return s->corners == std::get<Triangle>(b).corners;
  }
  return std::get<Quad4>(a).corner == std::get<Quad4>(b).corner;
}

TEST(ShapeList, GivesBackWhatItWasGiven) {
  std::vector<Shape> shapes;
  for (std::uint32_t k = 0; k < 600; ++k) {
    for (const Geometry& geometry : geometries(k)) {
      Shape shape{geometry, std::nullopt, k % 7, kNoId, "", {1, k / 3, k / 3 + 5}, 0};
      if (k % 5 == 0) shape.world_from_object = translation({1.0 * k, 0, 0});
      if (k % 11 == 0) shape.light = k;
      if (k % 13 == 0) shape.name = "thing " + std::to_string(k);
      shapes.push_back(shape);
    }
  }
  const ShapeList list = shapes;
  ASSERT_EQ(list.size(), shapes.size());
  std::size_t i = 0;
  for (const Shape& shape : list) {
    const Shape& expected = shapes[i];
    ASSERT_TRUE(same(shape.geometry, expected.geometry)) << i;
    ASSERT_EQ(shape.world_from_object, expected.world_from_object) << i;
    ASSERT_EQ(shape.material, expected.material) << i;
    ASSERT_EQ(shape.light, expected.light) << i;
    ASSERT_EQ(shape.name, expected.name) << i;
    ASSERT_EQ(list.name(i), expected.name) << i;
    ASSERT_EQ(shape.span, expected.span) << i;
    ASSERT_EQ(shape.number, 0U) << i;
    ++i;
  }
  EXPECT_EQ(i, shapes.size());
}

// A lamp's ball has a name and is not counted; balls with names of their own are.
TEST(ShapeList, NumberedShapesSayTheirNumber) {
  const auto ball = [](std::string name, ShapeId number) {
    return Shape{Sphere{}, std::nullopt, 0, kNoId, std::move(name), {}, number};
  };
  ShapeList list;
  list.push_back(ball("", 1));
  list.push_back(ball("lamp", 0));
  list.push_back(ball("table/", 2));
  list.push_back(ball("table/top", 0));
  list.push_back(ball("table/", 4));
  list.push_back({Plane{}, std::nullopt, 0, kNoId, "", {}, 1});
  list.push_back(ball("", 5));
  const char* const names[] = {"sphere 1",       "lamp",    "table/sphere 2", "table/top",
                               "table/sphere 4", "plane 1", "sphere 5"};
  for (std::size_t i = 0; i < list.size(); ++i)
    EXPECT_EQ(list.name(i), names[i]);
  EXPECT_EQ(list[4].number, 4U);
  EXPECT_EQ(list[1].number, 0U);
}

}  // namespace
}  // namespace alhazen
