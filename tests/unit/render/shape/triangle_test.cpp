#include "render/shape/triangle.h"

#include <gtest/gtest.h>

#include "render/shape/parallelogram.h"
#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

TEST(Triangle, ClosedForms) {
  const Triangle<double> triangle{{Vec3d{0, 0, 5}, Vec3d{4, 0, 5}, Vec3d{0, 4, 5}}};
  const Ray<double> ray{{1, 2, 0}, {0, 0, 2}};
  const auto hits = crossings(triangle, ray, Departure());
  ASSERT_EQ(hits.size(), 1);
  EXPECT_EQ(hits[0].t, 2.5);
  const auto point = surface(triangle, ray, hits[0]);
  EXPECT_EQ(point.position, Vec3d(1, 2, 5));
  EXPECT_EQ(point.normal, Vec3d(0, 0, 1));  // cross(b - a, c - a)
  EXPECT_FALSE(hits[0].enters);
  EXPECT_EQ(point.u, 0.25);
  EXPECT_EQ(point.v, 0.5);
  EXPECT_EQ(crossings(triangle, {{3, 2, 0}, {0, 0, 1}}, Departure()).size(), 0);
  EXPECT_EQ(crossings(triangle, ray, Departure{0}).size(), 0);
  EXPECT_EQ(crossings(triangle, {{1, 1, 9}, {0, 0, 1}}, Departure()).size(), 0);
}

TEST(Triangle, EntersAgreesWithTheNormal) {
  Dice dice(5);
  int hit_count = 0;
  for (int i = 0; i < 60000; ++i) {
    Triangle<double> triangle{{dice.in_cube(1), dice.in_cube(1), dice.in_cube(1)}};
    triangle.reversed = i % 2 == 1;
    const Ray<double> ray{dice.in_cube(3), dice.direction()};
    for (const auto& hit : crossings(triangle, ray, Departure())) {
      const auto point = surface(triangle, ray, hit);
      EXPECT_EQ(hit.enters, dot(point.normal, ray.direction) < 0);
      ++hit_count;
    }
  }
  EXPECT_GT(hit_count, 200);
}

TEST(Triangle, SmoothNormalsInterpolate) {
  const double s = std::sqrt(0.5);
  Triangle<double> triangle{{Vec3d{0, 0, 0}, Vec3d{2, 0, 0}, Vec3d{0, 2, 0}}};
  triangle.normals = {Vec3d{-s, 0, s}, Vec3d{s, 0, s}, Vec3d{0, 0, 1}};
  triangle.smooth = true;
  const Ray<double> ray{{1, 0, 5}, {0, 0, -1}};
  const auto point = surface(triangle, ray, crossings(triangle, ray, Departure())[0]);
  EXPECT_EQ(point.shading_normal, Vec3d(0, 0, 1));
  for (Vec3d& n : triangle.normals)
    n = -n;  // turned over to the geometric side
  EXPECT_EQ(surface(triangle, ray, crossings(triangle, ray, Departure())[0]).shading_normal,
            Vec3d(0, 0, 1));
}

// A13: no area, no hit.
TEST(Triangle, DegenerateIsNeverHit) {
  Dice dice(6);
  const Triangle<double> line{{Vec3d{0, 0, 0}, Vec3d{1, 1, 1}, Vec3d{3, 3, 3}}};
  const Triangle<double> edge_on{{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 0, 1}}};
  for (int i = 0; i < 1000; ++i) {
    const double x = dice.uniform(0, 1);
    EXPECT_EQ(crossings(line, {{x, x, -2}, {0, 0, 1}}, Departure()).size(), 0);
    EXPECT_EQ(crossings(edge_on, {{x, 0, -2}, {0, 0, 1}}, Departure()).size(), 0);
  }
}

// A12: a tessellated sphere lets no ray out, aimed at corners and edges too, nor in and not out.
TEST(Triangle, TessellatedSphereIsWatertight) {
  std::vector<Triangle<double>> mesh;
  const int around = 24, up = 12;
  const auto corner = [&](int i, int j) {
    const double turn = (i % around) / double{around}, tilt = 0.5 * j / double{up};
    if (j == 0 || j == up) return Vec3d{0, j == 0 ? -1.0 : 1.0, 0};
    return Vec3d{sin_cos_of_turns(turn).cos * sin_cos_of_turns(tilt).sin,
                 -sin_cos_of_turns(tilt).cos,
                 sin_cos_of_turns(turn).sin * sin_cos_of_turns(tilt).sin};
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < up; ++j) {
      const Vec3d a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                  d = corner(i, j + 1);
      if (j > 0) mesh.push_back({{a, b, c}});
      if (j < up - 1) mesh.push_back({{a, c, d}});
    }
  }
  Dice dice(7);
  int leaks = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d origin = dice.in_cube(0.3);
    const Triangle<double>& aim = mesh[static_cast<std::size_t>(dice.below(int(mesh.size())))];
    const double along = i % 3 == 0 ? 0 : dice.uniform(0, 1);
    const Vec3d target = aim.corners[0] + along * (aim.corners[1] - aim.corners[0]);
    int hits = 0;
    for (const auto& triangle : mesh) {
      hits += crossings(triangle, {origin, target - origin}, Departure()).size();
    }
    leaks += hits == 0;
  }
  EXPECT_EQ(leaks, 0);
}

TEST(Parallelogram, ClosedForms) {
  const Parallelogram<double> quad{
      {Vec3d{0, 0, 0}, Vec3d{4, 0, 0}, Vec3d{5, 2, 0}, Vec3d{1, 2, 0}}};
  for (const double u : {0.0, 0.25, 0.75, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) {
      const Ray<double> ray{{4 * u + v, 2 * v, 3}, {0, 0, -1}};
      const auto hits = crossings(quad, ray, Departure());
      ASSERT_EQ(hits.size(), 1) << u << ' ' << v;
      EXPECT_EQ(hits[0].t, 3);
      EXPECT_TRUE(hits[0].enters);
      const auto point = surface(quad, ray, hits[0]);
      EXPECT_EQ(point.u, u);
      EXPECT_EQ(point.v, v);
      EXPECT_EQ(point.position, Vec3d(4 * u + v, 2 * v, 0));
      EXPECT_EQ(point.normal, Vec3d(0, 0, 1));
    }
  }
  EXPECT_EQ(crossings(quad, {{0.2, 1, 3}, {0, 0, -1}}, Departure()).size(), 0);
}

}  // namespace
}  // namespace alhazen::render
