// tests/hard/pictures: D1 to D3, rooms of mirrors.
#include "core/math/elementary.h"
#include "hard/pictures/support.h"
#include "render/shape/sphere.h"
#include "render/surface/refract.h"

namespace alhazen::hard {
namespace {

constexpr double kGlow = 0.0078125, kSky = 1024;  // sums of 2^-7 are exact in either scalar type

using Room = std::vector<Geometry>;

Room six_planes(double s) {
  Room room;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3d normal;
      normal[axis] = -sign;
      room.push_back(Plane{normal, -s});
    }
  }
  return room;
}

// Two triangles a wall: each corner of the room is shared by four to six of them.
Room twelve_triangles(double s) {
  Room room;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const auto corner = [=](double u, double v) {
        Vec3d p;
        p[axis] = sign * s;
        p[(axis + 1) % 3] = u * s;
        p[(axis + 2) % 3] = v * s;
        return p;
      };
      room.push_back(Triangle{{corner(-1, -1), corner(1, -1), corner(1, 1)}, {}});
      room.push_back(Triangle{{corner(-1, -1), corner(1, 1), corner(-1, 1)}, {}});
    }
  }
  return room;
}

struct Leaks {
  int escapes = 0;
  double worst = 0;
};

// Each meeting adds kGlow; who gets out sees kSky.
void look_for_leaks(const Room& room, Precision p, double s, int bounces, int side, Leaks& leaks) {
  SceneBuilder b;
  b.background(kSky);
  const MaterialId worn = b.material(Mirror{b.color(Rgbd(1))}, Rgbd(kGlow));
  for (const Geometry& wall : room)
    b.add(wall, worn);
  b.scene.settings.max_depth = bounces;
  set_size(b, side);
  b.look(s * Vec3d(0.1, 0.2, -0.3), normalized(Vec3d(0, 0.1, 1)), normalized(Vec3d(0, 1, -0.1)),
         90);
  const std::vector<double> rgb = pixels(b.scene, p);
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    leaks.escapes += !(rgb[i] < kSky);
    leaks.worst = std::max(leaks.worst, std::abs(rgb[i] - kGlow * (bounces + 1)));
  }
}

void rooms_do_not_leak(Precision p) {
  const char* names[] = {"sphere", "box", "cylinder", "cone", "six planes", "twelve triangles"};
  for (int kind = 0; kind < 6; ++kind) {
    Leaks leaks;
    for (const double s : sizes(p)) {
      const Room rooms[] = {{Sphere{{0, 0, 0}, s}},
                            {Box{{-s, -s, -s}, {s, s, s}}},
                            {Cylinder{{0, -s, 0}, {0, s, 0}, s, true}},
                            {Cone{{0, -s, 0}, {0, s, 0}, 2 * s, s / 2, true}},
                            six_planes(s),
                            twelve_triangles(s)};
      const int side = kind < 4 ? 32 : 16;  // twelve shapes cost twelve times as much
      look_for_leaks(rooms[kind], p, s, 200, side_for(side), leaks);
      if (s == 1) look_for_leaks(rooms[kind], p, s, 5, side_for(side), leaks);
    }
    const std::string what = std::string(names[kind]) + ": ";
    figure("D1", name_of(p), what + "escaped rays, 5 to 200 bounces, all sizes", leaks.escapes, 0);
    figure("D1", name_of(p), what + "error of the sum", leaks.worst, 1e-12);
  }
}

TEST(Hard, D1_MirrorRooms) {
  for (const Precision p : kScalars)
    rooms_do_not_leak(p);
}

TEST(Hard, D1_TorusAndCsgRooms) {
  GTEST_SKIP() << "D1: there is no torus and no CSG yet";
}

// A path in a ball of mirrors: the angle of incidence is that of the first meeting for ever.
template <class Real>
double worst_drift(int bounces) {
  const render::Sphere<Real> room{{}, Real(1)};
  double worst = 0;
  for (int k = 0; k < 64; ++k) {
    // From near the centre to nearly along the wall.
    render::Ray<Real> ray{{Real((k + 0.5) / 64), Real(0), Real(0)},
                          normalized(Vec3<Real>(Real(0.1), Real(0.3), Real(1)))};
    render::Departure from;
    Real first = 0;
    for (int i = 0; i < bounces; ++i) {
      const auto met = render::crossings(room, ray, from);
      EXPECT_EQ(met.size(), 1);
      if (met.size() != 1) return infinity<double>();
      const auto at = render::surface<false>(room, ray, met[0]);
      const Real cosine = dot(ray.direction, at.normal);
      if (i == 0) first = cosine;
      worst = std::max(worst, static_cast<double>(absolute(cosine - first)));
      ray = {at.position, render::reflected(ray.direction, at.normal)};
      from = {0, render::Side::kBelow};
    }
  }
  return worst;
}

TEST(Hard, D2_AngleInAMirrorBall) {
  figure("D2", "double", "drift of the cosine over 200 bounces", worst_drift<double>(200), 1e-12);
  figure_beyond("D2", "float", "drift of the cosine over 200 bounces", worst_drift<float>(200),
                1e-12, "", "a rounding of float is 6e-8, 200 of them 1e-5");
}

// Two parallel mirrors of reflectance r that glow with a: a (1 - r^(N+1)) / (1 - r).
TEST(Hard, D3_ParallelMirrors) {
  for (const Precision p : kScalars) {
    double worst = 0;
    for (const double r : {0.5, 0.9, 0.99}) {
      for (const int depth : {0, 1, 5, 60, 200}) {
        SceneBuilder b;
        const double a = 0.25;
        const MaterialId worn = b.material(Mirror{b.color(Rgbd(r))}, Rgbd(a));
        b.add(Plane{{0, 0, -1}, -1}, worn);
        b.add(Plane{{0, 0, 1}, -1}, worn);
        b.scene.settings.max_depth = depth;
        const double expected = a * (1 - std::pow(r, depth + 1)) / (1 - r);
        const double value = seen(b, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, p);
        worst = std::max(worst, std::abs(value / expected - 1));
      }
    }
    if (p == Precision::float64) {
      figure("D3", name_of(p), "geometric series, up to 200 reflections", worst, 1e-13);
    } else {
      figure_beyond("D3", name_of(p), "geometric series, up to 200 reflections", worst, 1e-13, "",
                    "r itself is rounded to 6e-8, and 200 products of it");
    }
  }
}

}  // namespace
}  // namespace alhazen::hard
