// B6: rays that meet the hollow shape that they leave, bounce after bounce.
#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/zoo.h"

namespace alhazen::hard {
namespace {

#if ALHAZEN_HAS_QUAD
constexpr int kBounces = 50;

// The faces that a ray meets inside of a mirror room; how near each meeting came to another face,
// relative to the room, is the smallest gap between the answer and the answers of the other faces.
template <class Real>
struct Walk {
  const ShapeTable<Real>& room;
  Ray<Real> ray;
  Departure from;

  // The next face, or kNoFace when the room has lost the ray.
  int step() {
    const auto hits = room.crossings(0, ray, from);
    if (hits.size() != 1) return render::kNoFace;
    const auto point = room.plain_surface(0, ray, hits[0]);
    ray = {point.position, normalized(render::reflected(ray.direction, point.normal))};
    from = {hits[0].face, Side::kBelow};
    return hits[0].face;
  }
};

// How far a point on the room of size 1 is from its nearest edge or rim.
double distance_from_edges(const Geometry& room, Vec3d p) {
  if (std::holds_alternative<alhazen::Box>(room)) {
    double gaps[] = {1 - std::abs(p.x), 1 - std::abs(p.y), 1 - std::abs(p.z)};
    std::sort(std::begin(gaps), std::end(gaps));
    return gaps[1];  // the smallest is 0: the face that it is on
  }
  if (std::holds_alternative<alhazen::Sphere>(room)) return 1;
  const double from_rim = 1 - std::abs(p.y), from_side = 1 - std::hypot(p.x, p.z);
  return larger(std::abs(from_rim), std::abs(from_side));
}

struct RoomTally {
  double lost = 0, differing = 0;
  std::size_t compared = 0;
};

// Side by side with Quad until a meeting comes nearer to an edge than `certain`, where the oracle
// no longer certifies that another precision meets the same face.
template <class Real>
void walk(const Geometry& geometry, double certain, Dice& dice, RoomTally& tally) {
  const ShapeTable<Real> room({shape_of(geometry)}, Vec3d{});
  const ShapeTable<Quad> exact_room({shape_of(geometry)}, Vec3d{});
  const Ray<Real> start = ray_of<Real>(dice.in_cube(0.5), dice.direction());
  Walk<Real> got{room, start, {}};
  Walk<Quad> truth{exact_room, exact(start), {}};
  bool certified = true;
  for (int bounce = 0; bounce < kBounces; ++bounce) {
    const int face = got.step();
    if (face == render::kNoFace) {
      ++tally.lost;
      return;
    }
    if (!certified) continue;
    const int true_face = truth.step();
    certified = distance_from_edges(geometry, Vec3d(truth.ray.origin)) > certain;
    if (!certified) continue;
    ++tally.compared;
    if (face != true_face) ++tally.differing;
  }
}

template <class Real>
void rooms(double certain) {
  const std::vector<Geometry> geometries = {alhazen::Sphere{{0, 0, 0}, 1},
                                            alhazen::Box{{-1, -1, -1}, {1, 1, 1}},
                                            Cylinder{{0, -1, 0}, {0, 1, 0}, 1, true}};
  RoomTally tally;
  Dice dice(260);
  for (std::size_t i = 0; i < rays(60); ++i) {
    for (const Geometry& geometry : geometries)
      walk<Real>(geometry, certain, dice, tally);
  }
  EXPECT_GT(tally.compared, rays(5000));
  figure_in<Real>("B6", "rays lost in a sphere, a box or a cylinder in 50 bounces", tally.lost, 0);
  figure_in<Real>("B6", "faces that differ from the oracle's where it is certain", tally.differing,
                  0);
}

// A bounce adds a few roundings to direction and position, and a curved wall spreads what came
// before linearly: over 50 bounces to less than 50^2 of them, a thousand times less than this.
TEST(Hard, B6_Rooms) {
  rooms<double>(1e-9);
  rooms<float>(1e-2);
}
#endif

TEST(Hard, B6_Torus) {
  GTEST_SKIP() << "no torus yet";
}

}  // namespace
}  // namespace alhazen::hard
