#include "render/shape/shape_table.h"

#include <gtest/gtest.h>

#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

// One shape written twice: in place, and placed by an exact transform.
TEST(ShapeTable, ExactTransformsAgreeInBits) {
  const Affined turn = translation({4, -2, 8}) * rotation({0, 1, 0}, 90) * scaling({2, 2, 2});
  // (x, y, z) -> (2z + 4, 2y - 2, -2x + 8)
  const std::vector<Shape> placed = {
      shape_of(alhazen::Sphere{{1, 2, 3}, 1}, turn),
      shape_of(alhazen::Box{{0, 0, 0}, {1, 2, 3}}, turn),
      shape_of(alhazen::Plane{{1, 0, 0}, 3}, turn),
      shape_of(alhazen::Triangle{{Vec3d{0, 0, 0}, Vec3d{1, 2, 0}, Vec3d{0, 1, 3}}, {}}, turn),
      shape_of(Quad4{{0, 0, 0}, {1, 0, 2}, {0, 3, 1}}, turn)};
  const std::vector<Shape> plain = {
      shape_of(alhazen::Sphere{{10, 2, 6}, 2}), shape_of(alhazen::Box{{4, -2, 6}, {10, 2, 8}}),
      shape_of(alhazen::Plane{{0, 0, -1}, -2}),
      shape_of(alhazen::Triangle{{Vec3d{4, -2, 8}, Vec3d{4, 2, 6}, Vec3d{10, 0, 8}}, {}}),
      shape_of(Quad4{{4, -2, 8}, {4, 0, -2}, {2, 6, 0}})};
  const ShapeTable<double> a(placed, Vec3d{}), b(plain, Vec3d{});
  Dice dice(31);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d from = 8.0 * dice.direction() + Vec3d{6, 0, 7};
    const Ray<double> ray{from, Vec3d{6, 0, 7} + dice.in_cube(3) - from};
    for (ShapeId id = 0; id < a.size(); ++id) {
      const auto x = a.crossings(id, ray, Departure()), y = b.crossings(id, ray, Departure());
      ASSERT_EQ(x.size(), y.size()) << id;
      for (int k = 0; k < x.size(); ++k) {
        ++hits;
        // The origin in the object frame is rounded once more; sizes to 16, angles above 0.01.
        EXPECT_NEAR(x[k].t, y[k].t, 100 * 16 * 8 * kU) << id;
        const auto p = a.surface(id, ray, x[k]), q = b.surface(id, ray, y[k]);
        EXPECT_NEAR(length(p.position - q.position), 0, 100 * 16 * 16 * kU) << id;
        EXPECT_GT(dot(p.normal, q.normal), 1 - 0x1p-20) << id;
        EXPECT_EQ(x[k].enters, y[k].enters);
      }
    }
  }
  EXPECT_GT(hits, 3000);
}

// A14: an ellipsoid's normal is the gradient of its equation.
TEST(ShapeTable, EllipsoidNormal) {
  const Vec3d radii{2, 0.5, 1};
  const ShapeTable<double> table({shape_of(alhazen::Sphere{{}, 1}, scaling(radii))}, Vec3d{});
  Dice dice(32);
  for (int i = 0; i < 1000; ++i) {
    const Ray<double> ray{6.0 * dice.direction(), {}};
    const Ray<double> aimed{ray.origin, 0.2 * dice.direction() - ray.origin};
    const auto hits = table.crossings(0, aimed, Departure());
    ASSERT_EQ(hits.size(), 2);
    const auto point = table.surface(0, aimed, hits[0]);
    const Vec3d p = point.position;
    const Vec3d object{p.x / radii.x, p.y / radii.y, p.z / radii.z};
    EXPECT_NEAR(dot(object, object), 1, 8 * kU);
    const Vec3d gradient =
        normalized(Vec3d{object.x / radii.x, object.y / radii.y, object.z / radii.z});
    EXPECT_NEAR(length(gradient - point.normal), 0, 16 * kU);
    EXPECT_NEAR(length(point.object_position - object), 0, 4 * kU);
  }
}

// A transform that mirrors turns no surface inside out.
TEST(ShapeTable, MirroredNormalsStayOutward) {
  const Affined mirror = scaling({-1, 1, 1});
  const Geometry kinds[] = {
      alhazen::Sphere{{3, 0, 0}, 1}, alhazen::Plane{{1, 0, 0}, 2},
      alhazen::Triangle{{Vec3d{2, -1, -1}, Vec3d{2, 2, -1}, Vec3d{2, -1, 2}}, {}},
      Quad4{{2, -1, -1}, {0, 2, 0}, {0, 0, 2}}};
  for (const Geometry& geometry : kinds) {
    const ShapeTable<double> plain({shape_of(geometry)}, Vec3d{});
    const ShapeTable<double> flipped({shape_of(geometry, mirror)}, Vec3d{});
    const Ray<double> ray{{0, 0, 0}, {1, 0, 0}}, other{{0, 0, 0}, {-1, 0, 0}};
    const auto a = plain.crossings(0, ray, Departure()),
               b = flipped.crossings(0, other, Departure());
    ASSERT_GT(a.size(), 0);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(a[0].enters, b[0].enters) << kind_name(geometry);
    const Vec3d n = plain.surface(0, ray, a[0]).normal, m = flipped.surface(0, other, b[0]).normal;
    EXPECT_EQ(n, Vec3d(-m.x, m.y, m.z)) << kind_name(geometry);
  }
}

TEST(ShapeTable, ObjectPositionIsWhereTheSceneSaysIt) {
  const Vec3d camera{100, 50, -20};
  const ShapeTable<double> table({shape_of(alhazen::Plane{{0, 1, 0}, 0}),
                                  shape_of(alhazen::Plane{{0, 1, 0}, 0}, translation({0, 1, 0})),
                                  shape_of(alhazen::Box{{0, 0, 0}, {1, 1, 1}}, scaling({8, 8, 8}))},
                                 camera);
  const Ray<double> down{{-96, 0, 24}, {0, -1, 0}};
  const Vec3d expected[] = {{4, 0, 4}, {4, 0, 4}, {0.5, 1, 0.5}};
  for (ShapeId id = 0; id < 3; ++id) {
    const auto point = table.surface(id, down, table.crossings(id, down, Departure())[0]);
    EXPECT_EQ(point.object_position, expected[id]) << id;
  }
  // The plane's u and v do not move with the camera.
  const auto ground = table.surface(0, down, table.crossings(0, down, Departure())[0]);
  EXPECT_EQ(ground.u, 4);
  EXPECT_EQ(ground.v, 4);
  EXPECT_TRUE(table.contains(2, Vec3d{1, 1, 1} - camera));
  EXPECT_FALSE(table.contains(2, Vec3d{9, 1, 1} - camera));
}

// The kernels of other scalar types give the same hits, within their own roundings: rays through
// the middle of solids meet them steeply (cosine above 0.05), from distances below 16.
template <class Real>
void expect_agreement(double unit_roundoff) {
  Dice dice(33);
  int hits = 0;
  for (int round = 0; round < 100; ++round) {
    std::vector<Shape> shapes;
    for (const Geometry& solid : random_solids(dice, 1))
      shapes.push_back(shape_of(solid));
    const ShapeTable<double> base(shapes, Vec3d{});
    const ShapeTable<Real> other(shapes, Vec3d{});
    for (ShapeId id = 0; id < base.size(); ++id) {
      for (int i = 0; i < 10; ++i) {
        const Vec3d d = dice.direction();
        const Ray<double> ray{inner_point(shapes[id].geometry) - 8.0 * d, d};
        const Ray<Real> same{Vec3<Real>(ray.origin), Vec3<Real>(ray.direction)};
        const auto a = base.crossings(id, ray, Departure());
        const auto b = other.crossings(id, same, Departure());
        ASSERT_EQ(a.size(), 2);
        ASSERT_EQ(b.size(), 2);
        for (int k = 0; k < 2; ++k) {
          EXPECT_NEAR(static_cast<double>(b[k].t), a[k].t, 20 * 16 * 16 * unit_roundoff) << id;
          if (a[k].face != b[k].face) continue;  // met at an edge
          ++hits;
          const Vec3d p(other.surface(id, same, b[k]).position);
          EXPECT_LE(length(p - base.surface(id, ray, a[k]).position), 20 * 16 * 16 * unit_roundoff);
        }
      }
    }
  }
  EXPECT_GT(hits, 9000);
}

TEST(ShapeTable, FloatAgreesWithDouble) {
  expect_agreement<float>(0x1p-24);
}
#if ALHAZEN_HAS_QUAD
TEST(ShapeTable, QuadAgreesWithDouble) {
  expect_agreement<Quad>(kU);
}
#endif

}  // namespace
}  // namespace alhazen::render
