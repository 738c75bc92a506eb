#include "render/accel/closest_hit.h"

#include <gtest/gtest.h>

#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

constexpr double kFar = infinity<double>();

TEST(ClosestHit, NearestOfMany) {
  const ShapeTable<double> table(
      {shape_of(alhazen::Sphere{{0, 0, 9}, 1}), shape_of(alhazen::Sphere{{0, 0, 5}, 1}),
       shape_of(alhazen::Plane{{0, 0, -1}, -20})},
      Vec3d{});
  const Ray<double> ray{{0, 0, 0}, {0, 0, 1}};
  const auto hit = closest_hit(table, ray, Source(), kFar);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->shape, 1u);
  EXPECT_EQ(hit->t, 4);
  // The interval is closed at its end.
  EXPECT_TRUE(closest_hit(table, ray, Source(), 4.0).has_value());
  EXPECT_FALSE(closest_hit(table, ray, Source(), 4 - 4 * kU).has_value());
  EXPECT_FALSE(any_hit(table, ray, Source(), 4 - 4 * kU));
  EXPECT_TRUE(any_hit(table, ray, Source(), 4.0));
}

TEST(ClosestHit, EmptyTable) {
  const ShapeTable<double> table({}, Vec3d{});
  EXPECT_FALSE(closest_hit(table, {{0, 0, 0}, {0, 0, 1}}, Source(), kFar).has_value());
  EXPECT_FALSE(any_hit(table, {{0, 0, 0}, {0, 0, 1}}, Source(), kFar));
}

// Two boxes with a face in common: into the second before out of the first.
TEST(ClosestHit, CoincidentFacesAreOrderedByRule) {
  const alhazen::Box near_box{{-1, -1, 0}, {1, 1, 1}}, far_box{{-1, -1, 1}, {1, 1, 2}};
  for (const bool near_first : {true, false}) {
    const ShapeTable<double> table(
        {shape_of(near_first ? near_box : far_box), shape_of(near_first ? far_box : near_box)},
        Vec3d{});
    const ShapeId near_id = near_first ? 0 : 1, far_id = 1 - near_id;
    const Ray<double> ray{{0.25, 0.5, -3}, {0, 0, 1}};
    std::vector<Hit<double>> walk;
    for (auto hit = closest_hit(table, ray, Source(), kFar); hit;
         hit = next_hit(table, ray, Source(), *hit, kFar)) {
      walk.push_back(*hit);
      ASSERT_LE(walk.size(), 4u);
    }
    ASSERT_EQ(walk.size(), 4u);
    EXPECT_EQ(walk[0].shape, near_id);
    EXPECT_EQ(walk[1].shape, far_id);
    EXPECT_TRUE(walk[1].enters);
    EXPECT_EQ(walk[2].shape, near_id);
    EXPECT_FALSE(walk[2].enters);
    EXPECT_EQ(walk[1].t, walk[2].t);
    EXPECT_EQ(walk[3].shape, far_id);
  }
}

// B3: four shells with gaps down to 16 ulp, each crossed twice. POV-Ray 3.7 loses crossings from
// a gap of 9e-5.
TEST(NextHit, CountsShellsHoweverThin) {
  for (double gap = 0.1; gap > 16 * 2 * kU; gap /= 7) {
    std::vector<Shape> shapes;
    for (int i = 0; i < 4; ++i)
      shapes.push_back(shape_of(alhazen::Sphere{{0, 0, 5}, 1 + i * gap}));
    const ShapeTable<double> table(shapes, Vec3d{});
    Dice dice(41);
    for (int i = 0; i < 200; ++i) {
      const Ray<double> ray{{0, 0, 0}, Vec3d{0, 0, 5} + dice.in_cube(0.5)};
      int crossings_seen = 0, depth = 0;
      for (auto hit = closest_hit(table, ray, Source(), kFar); hit;
           hit = next_hit(table, ray, Source(), *hit, kFar)) {
        depth += hit->enters ? 1 : -1;
        ASSERT_GE(depth, 0);
        ASSERT_LE(++crossings_seen, 8);
      }
      EXPECT_EQ(crossings_seen, 8) << gap;
      EXPECT_EQ(depth, 0);
    }
  }
}

// The same, by leaving each surface in turn, as a refracted ray does.
TEST(ClosestHit, CountsShellsWhenRestarted) {
  for (double gap = 0.1; gap > 1e-13; gap /= 7) {
    std::vector<Shape> shapes;
    for (int i = 0; i < 4; ++i)
      shapes.push_back(shape_of(alhazen::Sphere{{0, 0, 5}, 1 + i * gap}));
    const ShapeTable<double> table(shapes, Vec3d{});
    Dice dice(42);
    for (int i = 0; i < 200; ++i) {
      Ray<double> ray{{0, 0, 0}, normalized(Vec3d{0, 0, 5} + dice.in_cube(0.5))};
      Source source;
      int count = 0;
      while (const auto hit = closest_hit(table, ray, source, kFar)) {
        ASSERT_LE(++count, 8) << gap;
        const auto point = table.surface(hit->shape, ray, hit->crossing());
        ray.origin = point.position;
        source = {hit->shape, hit->face, hit->enters ? Side::kBelow : Side::kAbove};
      }
      EXPECT_EQ(count, 8) << gap;
    }
  }
}

// B2 and B1 in one: a ray from the ground towards a light is stopped by the sphere that stands on
// it, not by the ground.
TEST(AnyHit, TheSourceDoesNotShadowItself) {
  const ShapeTable<double> table(
      {shape_of(alhazen::Plane{{0, 1, 0}, 0}), shape_of(alhazen::Sphere{{0, 1, 0}, 1})}, Vec3d{});
  // Light at height 10 above a unit sphere on the ground: the shadow is a disc of radius
  // sqrt(5)/2 (docs/numerics.md, B2).
  const double radius = std::sqrt(5.0) / 2;
  for (int i = 0; i < 360; ++i) {
    const SinCos<double> p = sin_cos_of_turns(i / 360.0);
    for (const double factor : {0.5, 1 - 0x1p-40, 1 + 0x1p-40, 2.0}) {
      const Vec3d at{radius * factor * p.cos, 0, radius * factor * p.sin};
      EXPECT_EQ(any_hit(table, {at, Vec3d{0, 10, 0} - at}, Source{0, 0, Side::kAbove}, 1.0),
                factor < 1)
          << i << ' ' << factor;
    }
  }
}

// A room of six planes and one of six quads: a mirrored ray stays, told by identity alone.
TEST(ClosestHit, RoomsOfSeveralShapesDoNotLeak) {
  std::vector<Shape> planes, quads;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3d n, corner{-1, -1, -1}, u, v;
      n[axis] = -sign;
      corner[axis] = sign;
      u[(axis + 1) % 3] = 2;
      v[(axis + 2) % 3] = 2;
      planes.push_back(shape_of(alhazen::Plane{n, -1}));
      quads.push_back(shape_of(Quad4{corner, u, v}));
    }
  }
  Dice dice(43);
  for (const auto& shapes : {planes, quads}) {
    const ShapeTable<double> table(shapes, Vec3d{});
    for (int i = 0; i < 100; ++i) {
      Ray<double> ray{dice.in_cube(0.9), dice.direction()};
      Source source;
      for (int bounce = 0; bounce < 200; ++bounce) {
        const auto hit = closest_hit(table, ray, source, kFar);
        ASSERT_TRUE(hit.has_value()) << i << ' ' << bounce;
        const auto point = table.surface(hit->shape, ray, hit->crossing());
        ray = {point.position, normalized(reflected(ray.direction, point.normal))};
        source = {hit->shape, hit->face};
      }
    }
  }
}

// Where three walls meet at the ray's own starting point, each is met or not by the side on which
// the ray stands, not by the rounding of t.
TEST(ClosestHit, CornersOfRoomsDoNotLeak) {
  std::vector<Shape> walls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3d n;
      n[axis] = -sign;
      walls.push_back(shape_of(alhazen::Plane{n, -1}));
    }
  }
  const ShapeTable<double> table(walls, Vec3d{});
  for (const Vec3d d : {Vec3d{1, 1, 1}, Vec3d{1, -1, 0}, Vec3d{0, 1, 1}, Vec3d{-1, 0.5, 0.5},
                        Vec3d{0.25, -1, -1}}) {
    Ray<double> ray{{0, 0, 0}, d};
    Source source;
    for (int bounce = 0; bounce < 300; ++bounce) {
      const auto hit = closest_hit(table, ray, source, kFar);
      ASSERT_TRUE(hit.has_value()) << bounce;
      ASSERT_TRUE(hit->enters) << bounce;  // walls face inwards: never from behind
      const auto point = table.surface(hit->shape, ray, hit->crossing());
      source = source_after(source, ray.direction, *hit, false);
      ray = {point.position, reflected(ray.direction, point.normal)};
    }
  }
}

// Two boxes with a face in common, left and entered anew at each face as refraction does: four
// crossings, none twice.
TEST(ClosestHit, CoincidentFacesAreCrossedOnce) {
  const ShapeTable<double> table({shape_of(alhazen::Box{{-1, -1, 0}, {1, 1, 1}}),
                                  shape_of(alhazen::Box{{-1, -1, 1}, {1, 1, 2}})},
                                 Vec3d{});
  Ray<double> ray{{0.25, 0.5, -3}, {0.125, 0.0625, 1}};
  Source source;
  int depth = 0, count = 0;
  while (const auto hit = closest_hit(table, ray, source, kFar)) {
    ASSERT_LE(++count, 4);
    depth += hit->enters ? 1 : -1;
    const auto point = table.surface(hit->shape, ray, hit->crossing());
    source = source_after(source, ray.direction, *hit, true);
    ray.origin = point.position;
  }
  EXPECT_EQ(count, 4);
  EXPECT_EQ(depth, 0);
}

}  // namespace
}  // namespace alhazen::render
