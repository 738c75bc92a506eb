// A12 and A13: a closed mesh seen through its corners and edges, and triangles that hardly are any.
#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/support.h"

namespace alhazen::hard {
namespace {

using render::Triangle;

template <class Real>
Triangle<Real> triangle_of(Vec3<Real> a, Vec3<Real> b, Vec3<Real> c) {
  Triangle<Real> triangle;
  triangle.corners = {a, b, c};
  return triangle;
}

// A sphere of 224 x 224 quads, 10^5 triangles, whose corners are rounded once: neighbours have the
// same ones. Only the triangles around one corner are made at a time: all that a ray to it, or to
// an edge of it, can meet on this side.
template <class Real>
class Mesh {
 public:
  static constexpr int kCells = 224;

  Vec3<Real> corner(int i, int j) const {
    if (j == 0 || j == kCells) return {Real(0), j == 0 ? Real(-1) : Real(1), Real(0)};
    const SinCos<double> around = sin_cos_of_turns((i + kCells) % kCells * (1.0 / kCells));
    const SinCos<double> up = sin_cos_of_turns(j * (0.5 / kCells) - 0.25);
    return Vec3<Real>(Vec3d{up.cos * around.cos, up.sin, up.cos * around.sin});
  }

  // The triangles of the four quads that share corner (i, j), which is no pole.
  std::vector<Triangle<Real>> around(int i, int j) const {
    std::vector<Triangle<Real>> ring;
    for (const int di : {-1, 0}) {
      for (const int dj : {-1, 0}) {
        const Vec3<Real> a = corner(i + di, j + dj), b = corner(i + di + 1, j + dj);
        const Vec3<Real> c = corner(i + di + 1, j + dj + 1), d = corner(i + di, j + dj + 1);
        if (!(a == b)) ring.push_back(triangle_of(a, b, c));
        if (!(c == d)) ring.push_back(triangle_of(a, c, d));
      }
    }
    return ring;
  }
};

template <class Real>
void closed_mesh() {
  const Mesh<Real> mesh;
  double missed = 0, shared = 0, in_front = 0;
  Dice dice(120);
  for (std::size_t n = 0; n < rays(100000); ++n) {
    const int i = dice.below(Mesh<Real>::kCells), j = 1 + dice.below(Mesh<Real>::kCells - 1);
    const Vec3<Real> at = mesh.corner(i, j);
    Vec3<Real> eye(0.9 * dice.in_cube(0.5));
    // The corner itself, the other end of one of its edges, or a point between the two.
    const Vec3<Real> end = n % 4 == 0   ? mesh.corner(i + 1, j)
                           : n % 4 == 1 ? mesh.corner(i, j + 1)
                           : n % 4 == 2 ? mesh.corner(i + 1, j + 1)
                                        : at;
    const Real along = static_cast<Real>(dice.uniform(0, 0.5));
    Vec3<Real> target = multiply_add(along, end - at, at);
    if (n % 8 == 3) {
      // Along an axis at the corner itself: the only rays that rounding does not move off it.
      const int axis = absolute(at.x) > Real(0.6) ? 0 : absolute(at.y) > Real(0.6) ? 1 : 2;
      eye = at;
      eye[axis] = Real(0);
      target = at;
    }
    const Ray<Real> ray{eye, target - eye};
    int hits = 0;
    Real nearest = infinity<Real>(), farthest = Real(0);
    for (const Triangle<Real>& triangle : mesh.around(i, j)) {
      for (const Crossing<Real>& hit : crossings(triangle, ray, Departure())) {
        ++hits;
        nearest = smaller(nearest, hit.t);
        farthest = larger(farthest, hit.t);
      }
    }
    if (hits == 0) ++missed;
    if (hits > 1) {
      ++shared;
      in_front = larger(in_front, static_cast<double>(farthest - nearest) / kEps<Real>);
    }
  }
  figure_in<Real>("A12", "rays through corners and edges of a closed mesh that miss it", missed, 0);
  // Who is met twice is met at one place: t is near 1 and each of the two rounds it by no more than
  // its 4 operations on numbers that are at most 2 in size.
  figure_in<Real>("A12", "distance between two hits on what triangles share", in_front, 16, "eps");
  figure_beyond("A12", kScalar<Real>, "share of these rays that meet two triangles or more",
                shared / static_cast<double>(rays(100000)), 0, "",
                "edges belong to both of their triangles; the nearest hit of a ray is one of them");
}

TEST(Hard, A12_ClosedMesh) {
  closed_mesh<double>();
  closed_mesh<float>();
}

// No area, or seen edge-on: never a hit.
template <class Real>
void no_area() {
  double false_hits = 0;
  Dice dice(130);
  for (std::size_t i = 0; i < rays(20000); ++i) {
    // Numbers of few bits, so that points on a line are exactly on it.
    const auto coarse = [&] {
      return Vec3<Real>(Vec3d(dice.below(17) - 8, dice.below(17) - 8, dice.below(17) - 8));
    };
    const Vec3<Real> a = coarse(), along = coarse(), d = coarse(), aside = coarse();
    if (d == Vec3<Real>()) continue;
    const Vec3<Real> line[] = {a, a + along, a + Real(dice.below(9) - 4) * along};
    const Ray<Real> to_line{line[i % 3] - Real(4) * d, d};
    const Triangle<Real> degenerate[] = {triangle_of(line[0], line[1], line[2]),
                                         triangle_of(a, a, a + along), triangle_of(a, a, a)};
    for (const Triangle<Real>& t : degenerate)
      false_hits += crossings(t, to_line, Departure()).size();
    // In the plane of the triangle, along it.
    const Triangle<Real> seen_edge_on = triangle_of(a, a + d, a + aside);
    const Ray<Real> in_plane{a - Real(3) * d + aside, d};
    false_hits += crossings(seen_edge_on, in_plane, Departure()).size();
  }
  figure_in<Real>("A13", "hits on triangles of no area and in the plane of the ray", false_hits, 0);
}

#if ALHAZEN_HAS_QUAD
// How far the line of a ray passes from the outline of a triangle, as the ray sees it.
double distance_from_outline(const render::ShearedRay<Quad>& ray, const Triangle<Quad>& triangle) {
  Quad nearest = infinity<Quad>();
  for (int i = 0; i < 3; ++i) {
    const auto flat = [&](int k) {
      const Vec3<Quad> p = ray.sheared(triangle.corners[static_cast<std::size_t>(k)]);
      return Vec3<Quad>{p.x, p.y, Quad(0)};
    };
    const Vec3<Quad> from = flat(i), edge = flat((i + 1) % 3) - from;
    const Quad squared = dot(edge, edge);
    const Quad at = squared > 0 ? smaller(Quad(1), larger(Quad(0), -dot(from, edge) / squared)) : 0;
    nearest = smaller(nearest, length(multiply_add(at, edge, from)));
  }
  return static_cast<double>(nearest);
}

// Needles down to 2^-40 of their length, of any place and size, aimed at from near to almost in
// their plane.
template <class Real>
void needles() {
  double from_outline = 0, out_of_range = 0;
  std::size_t met = 0;
  Dice dice(131);
  for (std::size_t i = 0; i < rays(8000); ++i) {
    const double size = std::ldexp(1.0, dice.below(21) - 10);
    const double width = std::ldexp(1.0, -dice.below(41)), lift = std::ldexp(1.0, -dice.below(41));
    const Vec3d a = dice.in_cube(2), along = size * dice.direction(), aside = aside_of(along, dice);
    const Vec3d b = a + along, c = a + dice.uniform(-0.5, 1.5) * along + size * width * aside;
    const Triangle<Real> needle = triangle_of(Vec3<Real>(a), Vec3<Real>(b), Vec3<Real>(c));
    const double u = dice.uniform(0, 1), v = dice.uniform(0, 1 - u);
    const Vec3d target = a + u * (b - a) + v * (c - a);
    const Vec3d d = normalized(dice.uniform(-1, 1) * along / size + dice.uniform(-1, 1) * aside +
                               lift * cross(along / size, aside));
    // From before all of its corners: t of a ray almost in its plane may be anywhere among theirs.
    const Ray<Real> ray = ray_of<Real>(target - (3 + 4 * size) * d, d);
    Triangle<Quad> oracle;
    for (std::size_t k = 0; k < 3; ++k)
      oracle.corners[k] = Vec3<Quad>(needle.corners[k]);
    const auto got = crossings(needle, ray, Departure());
    const auto truth = crossings(oracle, exact(ray), Departure());
    const render::ShearedRay<Quad> sheared(exact(ray));
    double largest = 0;  // of the corners as seen from the origin
    for (const Vec3<Quad>& corner : oracle.corners)
      largest = larger(largest, static_cast<double>(length(corner - exact(ray).origin)));
    if (got.size() != truth.size()) {
      from_outline =
          larger(from_outline, distance_from_outline(sheared, oracle) / (kEps<Real> * largest));
    }
    if (got.size() == 0) continue;
    ++met;
    // Among its corners, in the coordinate along which the ray moves fastest.
    Real low = infinity<Real>(), high = -infinity<Real>();
    const render::ShearedRay<Real> own(ray);
    for (const Vec3<Real>& corner : needle.corners) {
      const Real t = own.turned(corner - ray.origin).z * own.scale_z;
      low = smaller(low, t);
      high = larger(high, t);
    }
    const Real outside = larger(Real(0), larger(low - got[0].t, got[0].t - high));
    out_of_range = larger(out_of_range, static_cast<double>(outside / high) / kEps<Real>);
  }
  EXPECT_GT(met, rays(2000));
  // A corner is rounded when it is seen from the origin, when it is sheared and by the shear: by 3
  // eps of its size in each of two coordinates.
  figure_in<Real>("A13", "distance from the outline of needles wrongly met or missed", from_outline,
                  6, "eps of the largest corner");
  // Three weights whose sum is 1 to 3 eps, a sum of three products and one more.
  figure_in<Real>("A13", "t beyond those of the corners", out_of_range, 8, "eps");
}
#endif

TEST(Hard, A13_ThinTriangles) {
  no_area<double>();
  no_area<float>();
#if ALHAZEN_HAS_QUAD
  needles<double>();
  needles<float>();
#endif
}

TEST(Hard, A11_Torus) {
  GTEST_SKIP() << "no torus yet";
}

}  // namespace
}  // namespace alhazen::hard
