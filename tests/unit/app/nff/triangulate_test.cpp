#include "app/nff/triangulate.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "app/nff/orientation.h"

namespace alhazen {
namespace {

using Flat = std::vector<std::array<int, 2>>;

// Twice the signed area; exact for whole numbers.
double area(const Flat& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [ax, ay] = polygon[i];
    const auto& [bx, by] = polygon[(i + 1) % polygon.size()];
    sum += double(ax) * by - double(ay) * bx;
  }
  return sum;
}

// The whole-number plane, put into space so that nothing is rounded.
std::vector<Vec3d> in_space(const Flat& polygon, int plane) {
  std::vector<Vec3d> out;
  for (const auto& [x, y] : polygon) {
    const double u = x, v = y;
    const Vec3d point = plane == 0   ? Vec3d{u, v, 5}
                        : plane == 1 ? Vec3d{-7, u, v}
                        : plane == 2
                            ? Vec3d{v, 3, u}
                            : Vec3d{u + v, u - v, 2 * u + v};  // steep, and seen from behind
    out.push_back(point);
  }
  return out;
}

// Even-odd; the point lies on no edge.
bool is_inside(const Flat& polygon, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [ax, ay] = polygon[i];
    const auto& [bx, by] = polygon[(i + 1) % polygon.size()];
    if ((ay > y) != (by > y) && x < ax + (y - ay) * double(bx - ax) / (by - ay)) inside = !inside;
  }
  return inside;
}

// The triangles run as the polygon does, their areas add up to its area, and each of many points is
// in exactly one of them if it is inside and in none otherwise.
void expect_covered(const Flat& polygon) {
  const double whole = area(polygon);
  ASSERT_NE(whole, 0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-110, 110);
  for (int plane = 0; plane < 4; ++plane) {
    std::vector<TriangleCorners> triangles;
    ASSERT_EQ(triangulate(in_space(polygon, plane), triangles), PolygonKind::good);
    EXPECT_LE(triangles.size(), polygon.size() - 2);
    double sum = 0;
    std::vector<Flat> flat;
    for (const auto& [a, b, c] : triangles) {
      flat.push_back({polygon[a], polygon[b], polygon[c]});
      const double part = area(flat.back());
      EXPECT_GT(part * whole, 0);
      sum += part;
    }
    EXPECT_EQ(sum, whole);
    for (int i = 0; i < 200; ++i) {
      const double x = anywhere(random), y = anywhere(random);
      const auto over = std::ranges::count_if(
          flat, [&](const Flat& triangle) { return is_inside(triangle, x, y); });
      EXPECT_EQ(over, is_inside(polygon, x, y) ? 1 : 0) << x << " " << y;
    }
  }
}

void expect_covered_both_ways(Flat polygon) {
  expect_covered(polygon);
  std::ranges::reverse(polygon);
  expect_covered(polygon);
}

const Flat kComb = {{-90, -90}, {90, -90}, {90, 90},  {70, 90}, {70, -70}, {50, -70},  {50, 90},
                    {30, 90},   {30, -70}, {10, -70}, {10, 90}, {-10, 90}, {-10, -70}, {-90, -70}};

TEST(Triangulate, ConvexPolygons) {
  expect_covered_both_ways({{0, 0}, {50, 0}, {0, 50}});
  expect_covered_both_ways({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}});
  expect_covered_both_ways({{0, -50}, {40, -30}, {50, 10}, {10, 50}, {-40, 30}, {-50, -20}});
}

TEST(Triangulate, ConcavePolygonsFromEachCorner) {
  Flat arrow = {{-50, -50}, {60, 0}, {-50, 50}, {-20, 0}};
  for (std::size_t i = 0; i < arrow.size(); ++i) {
    expect_covered_both_ways(arrow);
    std::ranges::rotate(arrow, arrow.begin() + 1);
  }
  Flat comb = kComb;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    expect_covered_both_ways(comb);
    std::ranges::rotate(comb, comb.begin() + 1);
  }
}

TEST(Triangulate, CornersAmidStraightEdgesAndCornersTwice) {
  expect_covered_both_ways({{-50, -50}, {0, -50}, {50, -50}, {50, 50}, {50, 50}, {-50, 50}});
  expect_covered_both_ways({{0, 0}, {30, 0}, {60, 0}, {90, 0}, {0, 90}, {0, 60}, {0, 30}});
  // A thorn of no width.
  expect_covered_both_ways({{-50, -50}, {50, -50}, {50, 0}, {90, 0}, {50, 0}, {50, 50}, {-50, 50}});
}

TEST(Triangulate, HolesJoinedToTheRim) {
  expect_covered_both_ways({{-90, -90},
                            {90, -90},
                            {90, 90},
                            {-90, 90},
                            {-90, -90},
                            {-30, -30},
                            {-30, 30},
                            {30, 30},
                            {30, -30},
                            {-30, -30}});
  // Two holes, one edge through both.
  expect_covered_both_ways({{-90, -90}, {90, -90},  {90, 90},   {-90, 90}, {-90, 0},
                            {-60, 0},   {-60, 40},  {-20, 40},  {-20, 0},  {20, 0},
                            {20, 40},   {60, 40},   {60, -40},  {20, -40}, {20, 0},
                            {-20, 0},   {-20, -40}, {-60, -40}, {-60, 0},  {-90, 0}});
}

TEST(Triangulate, PolygonsThatTouchThemselves) {
  // Two squares that share a corner and wind the same way.
  expect_covered_both_ways(
      {{0, 0}, {50, 0}, {50, 50}, {0, 50}, {0, 0}, {-50, 0}, {-50, -50}, {0, -50}});
}

// Stars: corners in the order of their angles around the origin, at any distance, on a coarse grid,
// so that many of them lie on one line.
TEST(Triangulate, RandomStars) {
  std::mt19937 random(42);
  for (int round = 0; round < 300; ++round) {
    Flat polygon;
    const int corners = 4 + static_cast<int>(random() % 40);
    const int step = round % 3 == 0 ? 20 : 1;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * 3.14159265358979 * i / corners;
      const double radius = 15 + static_cast<double>(random() % 85);
      polygon.push_back({static_cast<int>(std::lround(radius * std::cos(angle) / step)) * step,
                         static_cast<int>(std::lround(radius * std::sin(angle) / step)) * step});
    }
    // Rounding to the grid may make edges cross: then that is what has to be said.
    std::vector<TriangleCorners> triangles;
    if (step > 1 && triangulate(in_space(polygon, 0), triangles) != PolygonKind::good) continue;
    expect_covered(polygon);
  }
}

TEST(Triangulate, SpiralOfAThousandCorners) {
  Flat outer, inner;
  for (int i = 0; i < 500; ++i) {
    const double angle = 0.05 * i;
    outer.push_back({static_cast<int>(std::lround((20 + 3 * i) * std::cos(angle))),
                     static_cast<int>(std::lround((20 + 3 * i) * std::sin(angle)))});
    inner.push_back({static_cast<int>(std::lround((10 + 3 * i) * std::cos(angle))),
                     static_cast<int>(std::lround((10 + 3 * i) * std::sin(angle)))});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  expect_covered_both_ways(outer);
}

PolygonKind kind_of(const Flat& polygon) {
  std::vector<TriangleCorners> triangles;
  const PolygonKind kind = triangulate(in_space(polygon, 3), triangles);
  EXPECT_EQ(triangles.empty(), kind != PolygonKind::good);
  return kind;
}

TEST(Triangulate, SaysWhatIsNoPolygon) {
  EXPECT_EQ(kind_of({{0, 0}, {1, 1}, {2, 2}}), PolygonKind::no_area);
  EXPECT_EQ(kind_of({{0, 0}, {1, 1}, {5, 5}, {-3, -3}}), PolygonKind::no_area);
  EXPECT_EQ(kind_of({{4, 4}, {4, 4}, {4, 4}}), PolygonKind::no_area);
  // A bow whose halves are equal, one whose halves are not, a star of five points.
  EXPECT_EQ(kind_of({{0, 0}, {10, 10}, {10, 0}, {0, 10}}), PolygonKind::edges_cross);
  EXPECT_EQ(kind_of({{0, 0}, {10, 10}, {10, 0}, {0, 5}}), PolygonKind::edges_cross);
  EXPECT_EQ(kind_of({{0, 30}, {-20, -30}, {30, 10}, {-30, 10}, {20, -30}}),
            PolygonKind::edges_cross);
  // Halves that only touch, but wind in opposite ways.
  EXPECT_EQ(kind_of({{0, 0}, {50, 0}, {50, 50}, {0, 0}, {-60, 0}, {-60, -60}}), PolygonKind::good);
  EXPECT_EQ(kind_of({{0, 0}, {50, 0}, {50, 50}, {0, 0}, {-60, -60}, {-60, 0}}),
            PolygonKind::edges_cross);
  // A square gone around twice, from one corner and from the middle of an edge.
  EXPECT_EQ(kind_of({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {9, 0}, {9, 9}, {0, 9}}),
            PolygonKind::edges_cross);
  EXPECT_EQ(kind_of({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {5, 0}, {9, 0}, {9, 9}, {0, 9}}),
            PolygonKind::edges_cross);
  // There and back, with an area of 0, but not on one line.
  EXPECT_EQ(kind_of({{0, 0}, {10, 0}, {10, 10}, {10, 0}}), PolygonKind::edges_cross);
}

TEST(Triangulate, RoundingOfCoordinatesDoesNotDecide) {
  // A thin concave polygon, far from the origin, corners 1 ulp apart.
  const double x = 1e6, ulp = std::nextafter(x, 2e6) - x;
  const std::vector<Vec3d> thin = {
      {x, 0, 0}, {x + 4 * ulp, 0, 0}, {x + 4 * ulp, 1, 0}, {x + ulp, 0.5, 0}, {x, 1, 0}};
  std::vector<TriangleCorners> triangles;
  EXPECT_EQ(triangulate(thin, triangles), PolygonKind::good);
  EXPECT_EQ(triangles.size(), 3u);
}

TEST(Orientation, IsExact) {
  // 12 + k ulp in a line of slope 1: Shewchuk's picture of where plain arithmetic fails.
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const double ulp = 0x1p-53;
      const Point2 a{0.5 + i * ulp, 0.5 + j * ulp};
      const int expected = j > i ? 1 : j < i ? -1 : 0;
      EXPECT_EQ(orientation({12, 12}, {24, 24}, a), expected);
      EXPECT_EQ(orientation({24, 24}, {12, 12}, a), -expected);
      EXPECT_EQ(orientation(a, {12, 12}, {24, 24}), expected);
    }
  }
}

}  // namespace
}  // namespace alhazen
