// What must not change a bit: scales by powers of two, the length of the direction, mirrors, the
// place of the whole scene.
#include <gtest/gtest.h>

#include "unit/render/shape/support.h"

namespace alhazen::render {
namespace {

// All kinds at random; the same dice and scales by powers of two give the same shapes, scaled.
std::vector<Shape> random_shapes(std::uint64_t seed, double scale) {
  Dice dice(seed);
  std::vector<Shape> shapes;
  for (const Geometry& solid : random_solids(dice, scale))
    shapes.push_back(shape_of(solid));
  const Vec3d axis = scale * dice.direction(), normal = dice.direction();
  shapes.push_back(shape_of(Cylinder{scale * dice.in_cube(1), 4.0 * axis, scale, false}));
  shapes.push_back(shape_of(Cone{{}, axis, scale, 0.25 * scale, false}));
  shapes.push_back(shape_of(alhazen::Plane{normal, 0.5 * scale}));
  shapes.push_back(shape_of(alhazen::Disc{{}, normal, 2 * scale, 0.5 * scale}));
  const Vec3d a = scale * dice.in_cube(3), b = scale * dice.in_cube(3), c = scale * dice.in_cube(3);
  shapes.push_back(shape_of(alhazen::Triangle{{a, b, c}, {}}));
  shapes.push_back(shape_of(Quad4{a, b, c}));
  return shapes;
}

// F1 and A4: lengths times 2^k, direction times 2^j: t times 2^(k-j), and nothing else.
TEST(Invariance, PowersOfTwoChangeNoBit) {
  int hits_seen = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    const ShapeTable<double> plain(random_shapes(seed, 1), Vec3d{});
    for (const int k : {-300, -100, -10, -1, 1, 10, 100, 300}) {
      const double scale = std::ldexp(1.0, k);
      const ShapeTable<double> scaled(random_shapes(seed, scale), Vec3d{});
      for (const int j : {-100, 0, 100}) {
        if (std::abs(k) + std::abs(j) > 300) continue;  // the squares leave the range of double
        const double stretch = std::ldexp(1.0, j);
        Dice dice(seed + 100);
        for (int i = 0; i < 10; ++i) {
          const Ray<double> ray{dice.in_cube(3), dice.direction()};
          const Ray<double> there{scale * ray.origin, stretch * ray.direction};
          for (ShapeId id = 0; id < plain.size(); ++id) {
            const auto a = plain.crossings(id, ray, Departure());
            const auto b = scaled.crossings(id, there, Departure());
            ASSERT_EQ(a.size(), b.size()) << id << " 2^" << k;
            for (int n = 0; n < a.size(); ++n) {
              ++hits_seen;
              ASSERT_EQ(a[n].t, b[n].t * stretch / scale) << id << " 2^" << k << " 2^" << j;
              ASSERT_EQ(a[n].face, b[n].face);
              const auto p = plain.surface(id, ray, a[n]), q = scaled.surface(id, there, b[n]);
              ASSERT_EQ(scale * p.position, q.position) << id;
              ASSERT_EQ(p.normal, q.normal) << id;
              if (id == 7) continue;  // a plane's u and v are lengths
              ASSERT_EQ(p.u, q.u) << id;
              ASSERT_EQ(p.v, q.v) << id;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(hits_seen, 20000);
}

Vec3d mirrored(Vec3d v) {
  return {-v.x, v.y, v.z};
}

// F4: the picture in a mirror is the mirrored picture, to the last bit.
TEST(Invariance, MirrorChangesNoBit) {
  Dice dice(21);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = dice.in_cube(1), n = dice.direction(), q = p + 2.0 * n;
    const Vec3d a = dice.in_cube(2), b = dice.in_cube(2);
    const double r = dice.uniform(0.2, 1);
    const auto shapes = [&](auto map) {
      const Vec3d corner = map(p), other = map(p + Vec3d{r, 1, 2});
      return std::vector<Shape>{
          shape_of(alhazen::Sphere{map(p), r}),
          shape_of(alhazen::Plane{map(n), r}),
          shape_of(alhazen::Disc{map(p), map(n), 2 * r, r}),
          shape_of(Cylinder{map(p), map(q), r, true}),
          shape_of(Cone{map(p), map(q), r, 0, true}),
          shape_of(alhazen::Triangle{{map(p), map(a), map(b)}, {}}),
          shape_of(alhazen::Box{{smaller(corner.x, other.x), corner.y, corner.z},
                                {larger(corner.x, other.x), other.y, other.z}})};
    };
    const ShapeTable<double> plain(shapes([](Vec3d v) { return v; }), Vec3d{});
    const ShapeTable<double> flipped(shapes(mirrored), Vec3d{});
    const Ray<double> ray{dice.in_cube(3), dice.direction()};
    const Ray<double> flipped_ray{mirrored(ray.origin), mirrored(ray.direction)};
    for (ShapeId id = 0; id < plain.size(); ++id) {
      const auto here = plain.crossings(id, ray, Departure());
      const auto there = flipped.crossings(id, flipped_ray, Departure());
      ASSERT_EQ(here.size(), there.size()) << id;
      for (int k = 0; k < here.size(); ++k) {
        ASSERT_EQ(here[k].t, there[k].t) << id;
        ASSERT_EQ(mirrored(plain.surface(id, ray, here[k]).position),
                  flipped.surface(id, flipped_ray, there[k]).position)
            << id;
      }
    }
  }
}

// F3: a scene and its camera moved together by a representable vector.
TEST(Invariance, PlaceOfTheSceneChangesNoBit) {
  const Vec3d camera{1, -2, 3};
  for (const double distance : {0x1p10, 0x1p30, 0x1p40}) {
    const Vec3d move{distance, -distance, 2 * distance};
    const auto shapes = [&](Vec3d at) {
      const Vec3d p = Vec3d{0.5, 0.25, 4} + at;
      return std::vector<Shape>{
          shape_of(alhazen::Sphere{p, 1}),
          shape_of(alhazen::Box{p, p + Vec3d{1, 1, 1}}),
          shape_of(Cylinder{p, p + Vec3d{1, 2, 0}, 0.5, true}),
          shape_of(alhazen::Plane{{0, 1, 0}, at.y - 3}),
          shape_of(alhazen::Triangle{{p, p + Vec3d{2, 0, 0}, p + Vec3d{0, 2, 1}}, {}}),
          shape_of(alhazen::Sphere{{}, 1}, translation(p) * scaling({1, 2, 0.5}))};
    };
    const ShapeTable<double> here(shapes({}), camera), there(shapes(move), camera + move);
    Dice dice(22);
    for (int i = 0; i < 3000; ++i) {
      const Ray<double> ray{{}, dice.direction()};
      for (ShapeId id = 0; id < here.size(); ++id) {
        const auto a = here.crossings(id, ray, Departure());
        const auto b = there.crossings(id, ray, Departure());
        ASSERT_EQ(a.size(), b.size());
        for (int k = 0; k < a.size(); ++k) {
          ASSERT_EQ(a[k].t, b[k].t);
          ASSERT_EQ(here.surface(id, ray, a[k]).position, there.surface(id, ray, b[k]).position);
        }
      }
    }
  }
}

}  // namespace
}  // namespace alhazen::render
