// What is exported of (u, v), against the renderer's own kernels at points of each surface.
#include "app/povray/uv_frame.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "core/scene/shape.h"
#include "render/shape/shape_table.h"
#include "unit/app/povray/pov_function.h"

namespace alhazen {
namespace {

// Lengths here are about 1, and each of u and v takes a few dozen roundings.
constexpr double kRounding = 1e-12;
constexpr int kRays = 4000;

struct NamedGeometry {
  const char* name;
  Geometry geometry;
};

class UvFrames : public testing::TestWithParam<NamedGeometry> {};

// u is an angle in turns, so 0 and 1 are one.
double distance(double a, double b, bool turns) {
  const double d = std::fabs(a - b);
  return turns ? std::min(d, std::fabs(1 - d)) : d;
}

// Calls visit with each point where random rays through the shape's neighbourhood meet it.
template <class Visit>
int for_points(const Geometry& geometry, const Visit& visit) {
  const std::vector<Shape> shapes = {{geometry, std::nullopt, 0, kNoId, "", {}}};
  const render::ShapeTable<double> table(shapes, {});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  int points = 0;
  for (int i = 0; i < kRays; ++i) {
    const Vec3d from{3 * any(random), 3 * any(random), 3 * any(random)};
    const Vec3d to{any(random), any(random), any(random)};
    const render::Ray<double> ray{from, to - from};
    const auto crossings = table.crossings(0, ray, {});
    for (int c = 0; c < crossings.size(); ++c) {
      const auto surface = table.surface(0, ray, crossings[c]);
      if (dot(surface.position, surface.position) > 100) continue;
      visit(surface);
      ++points;
    }
  }
  return points;
}

TEST_P(UvFrames, AreThoseOfTheRenderer) {
  const Geometry& geometry = GetParam().geometry;
  const UvFrame frame = uv_frame(geometry);
  const int points = for_points(geometry, [&](const render::SurfacePoint<double>& surface) {
    const Vec3d p = surface.object_position;
    if (frame.uv_from_object) {
      const Vec3d uv = frame.uv_from_object->point(p);
      EXPECT_NEAR(uv.x, surface.u, kRounding);
      EXPECT_NEAR(uv.y, surface.v, kRounding);
      EXPECT_NEAR(uv.z, 0, kRounding);
      return;
    }
    const double u = PovFunction::value(frame.u, p), v = PovFunction::value(frame.v, p);
    ASSERT_TRUE(std::isfinite(u)) << frame.u;
    ASSERT_TRUE(std::isfinite(v)) << frame.v;
    // The arc cosine loses half of its digits near the poles, where sin(pi v) is small.
    const double pole = std::holds_alternative<Sphere>(geometry)
                            ? std::max(1e-3, std::sin(std::numbers::pi * surface.v))
                            : 1;
    const bool turns = !std::holds_alternative<Box>(geometry);
    EXPECT_LT(distance(u, surface.u, turns), kRounding / pole) << p.x << ' ' << p.y << ' ' << p.z;
    EXPECT_LT(distance(v, surface.v, false), kRounding / pole) << p.x << ' ' << p.y << ' ' << p.z;
  });
  EXPECT_GT(points, kRays / 20);
}

// On an end, on a box and on a disc POV-Ray wraps a picture otherwise or not at all.
TEST(UvFrame, OnlyWhatPovRayWrapsTheSameHasAWarp) {
  EXPECT_STREQ(uv_frame(Sphere{}).warp, "spherical");
  EXPECT_STREQ(uv_frame(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, false}).warp, "cylindrical");
  EXPECT_EQ(uv_frame(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, true}).warp, nullptr);
  EXPECT_EQ(uv_frame(Box{{0, 0, 0}, {1, 1, 1}}).warp, nullptr);
  EXPECT_EQ(uv_frame(Disc{{0, 0, 0}, {0, 1, 0}, 1, 0}).warp, nullptr);
}

const Vec3d kTilted = normalized(Vec3d{0.3, 0.8, -0.5});

INSTANTIATE_TEST_SUITE_P(
    All, UvFrames,
    testing::Values(
        NamedGeometry{"sphere", Sphere{{0.2, -0.1, 0.3}, 0.9}},
        NamedGeometry{"plane", Plane{kTilted, 0.4}},
        NamedGeometry{"plane_y", Plane{{0, 1, 0}, -0.5}},
        NamedGeometry{"plane_down", Plane{{0, -1, 0}, 0.5}},
        NamedGeometry{"box", Box{{-0.7, -0.4, -0.9}, {0.8, 0.5, 0.6}}},
        NamedGeometry{"disc", Disc{{0.1, 0.2, 0}, kTilted, 1.1, 0}},
        NamedGeometry{"ring", Disc{{0.1, 0.2, 0}, {0, 0, -1}, 1.1, 0.4}},
        NamedGeometry{"cylinder", Cylinder{{0.1, -0.6, 0}, {0.3, 0.7, 0.2}, 0.5, true}},
        NamedGeometry{"pipe", Cylinder{{0, 0.7, 0}, {0, -0.6, 0}, 0.5, false}},
        NamedGeometry{"cone", Cone{{0, -0.6, 0.1}, {0.2, 0.7, 0}, 0.8, 0, true}},
        NamedGeometry{"cone_down", Cone{{0, -0.6, 0.1}, {0.2, 0.7, 0}, 0, 0.8, true}},
        NamedGeometry{"frustum", Cone{{0, -0.6, 0.1}, {0.2, 0.7, 0}, 0.3, 0.7, true}},
        NamedGeometry{"open_frustum", Cone{{0, -0.6, 0.1}, {0.2, 0.7, 0}, 0.7, 0.3, false}},
        NamedGeometry{"triangle",
                      Triangle{{Vec3d{-1, -1, 0.1}, Vec3d{1, -0.8, 0}, Vec3d{0, 1, 0.3}}, {}}},
        NamedGeometry{"quad", Quad4{{-0.8, -0.8, 0.1}, {1.5, 0.2, 0.1}, {0.3, 1.4, -0.2}}}),
    [](const auto& shape) { return std::string(shape.param.name); });

}  // namespace
}  // namespace alhazen
