// A14: spheres under maps that stretch and shear by up to 10^6, against the ellipsoid's own
// equation in the world.
#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/zoo.h"

namespace alhazen::hard {
namespace {

#if ALHAZEN_HAS_QUAD
using Matrix = Affine<Quad>;

Vec3<Quad> column(const Matrix& m, std::size_t j) {
  return {m.rows[0][j], m.rows[1][j], m.rows[2][j]};
}

// By cofactors, in Quad: not the inverse that the renderer has.
Matrix inverse_of(const Matrix& m) {
  const Vec3<Quad> a = column(m, 0), b = column(m, 1), c = column(m, 2), t = column(m, 3);
  const Quad det = dot(a, cross(b, c));
  const Vec3<Quad> rows[] = {cross(b, c) / det, cross(c, a) / det, cross(a, b) / det};
  Matrix inverse;
  for (std::size_t i = 0; i < 3; ++i)
    inverse.rows[i] = {rows[i].x, rows[i].y, rows[i].z, -dot(rows[i], t)};
  return inverse;
}

Quad norm(const Matrix& m) {
  Quad sum = 0;
  for (std::size_t j = 0; j < 3; ++j)
    sum += length_squared(column(m, j));
  return square_root(sum);
}

struct EllipsoidTally {
  double t = 0, normal = 0, miscounted = 0;
  std::size_t met = 0;
};

// A map and its inverse, neither of them the renderer's.
struct Place {
  Matrix world_from_object, object_from_world = inverse_of(world_from_object);
  double condition = static_cast<double>(norm(world_from_object) * norm(object_from_world));
};

// One ray at the ellipsoid; the error of t is over the condition of the matrix and that of the
// crossing in object space.
template <class Real>
void cast(const ShapeTable<Real>& table, const Place& place, const Ray<Real>& ray,
          EllipsoidTally& tally) {
  const Ray<Quad> same = exact(ray);
  const Ray<Quad> own{place.object_from_world.point(same.origin),
                      place.object_from_world.vector(same.direction)};
  const render::Sphere<Quad> ball{{}, 1};
  const auto truth = crossings(ball, own, Departure());
  const auto got = table.crossings(0, ray, Departure());
  if (got.size() != truth.size()) {
    ++tally.miscounted;
    return;
  }
  if (got.size() == 0) return;
  ++tally.met;
  for (int i = 0; i < got.size(); ++i) {
    const double crossing = condition(ball, own, truth[i], static_cast<double>(length(own.origin)));
    tally.t = larger(tally.t, relative_error(got[i].t, truth[i].t) / (place.condition * crossing));
  }
  const auto point = table.surface(0, ray, got[0]);
  // Two directions along the surface at the point of the unit sphere that the renderer found.
  const Vec3<Quad> n = normalized(Vec3<Quad>(point.object_position));
  const Vec3<Quad> helper = absolute(n.x) < Quad(0.5) ? Vec3<Quad>{1, 0, 0} : Vec3<Quad>{0, 1, 0};
  const Vec3<Quad> across = normalized(cross(n, helper));
  for (const Vec3<Quad>& tangent : {across, cross(n, across)}) {
    const Vec3<Quad> in_world = normalized(place.world_from_object.vector(tangent));
    const double cosine =
        static_cast<double>(absolute(dot(in_world, Vec3<Quad>(point.normal)))) / kEps<Real>;
    tally.normal = larger(tally.normal, cosine);
  }
}

// `stretch`: the longest axis over the shortest.
template <class Real>
void ellipsoids(double stretch, bool turned, const std::string& what) {
  EllipsoidTally tally;
  Dice dice(140);
  for (std::size_t round = 0; round < rays(30); ++round) {
    Affined place = scaling({stretch, dice.uniform(0.5, 2), 1});
    place.rows[0][1] = stretch * dice.uniform(-0.5, 0.5);  // shear
    if (turned) place = rotation(dice.direction(), dice.uniform(0, 360)) * place;
    // The map of the table is of type Real, and the truth is about that one.
    const Affine<Real> rounded(place);
    const Place exact_place{Matrix(rounded)};
    const ShapeTable<Real> table({shape_of(alhazen::Sphere{{}, 1}, Affined(rounded))}, Vec3d{});
    for (int i = 0; i < 20; ++i) {
      const Vec3d target = place.point(0.8 * dice.in_cube(0.5));
      const Vec3d eye = place.point(dice.uniform(2, 4) * dice.direction());
      cast(table, exact_place, ray_of<Real>(eye, target - eye), tally);
    }
  }
  EXPECT_GT(tally.met, rays(400));
  figure_in<Real>("A14", "rays at the middle of ellipsoids that miss, " + what, tally.miscounted,
                  0);
  figure_in<Real>("A14", "error of t over the condition of map and crossing, " + what, tally.t, 16,
                  "eps");
  figure_in<Real>("A14", "cosine of normal and tangent, " + what, tally.normal, 4, "eps");
}

TEST(Hard, A14_Ellipsoid) {
  for (const bool turned : {false, true}) {
    const std::string how = turned ? " turned" : "";
    ellipsoids<double>(10, turned, "10:1" + how);
    ellipsoids<float>(10, turned, "10:1" + how);
    ellipsoids<double>(1e6, turned, "10^6:1" + how);
    ellipsoids<float>(1e6, turned, "10^6:1" + how);
  }
}
#endif

}  // namespace
}  // namespace alhazen::hard
