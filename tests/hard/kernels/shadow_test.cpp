// B1, B5 and B7: what a surface lets its own lights see.
#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/zoo.h"
#include "render/accel/closest_hit.h"
#include "render/light/point_light.h"

namespace alhazen::hard {
namespace {

using render::Hit;
using render::Source;

// A point of a shape, as a ray of the camera finds it.
template <class Real>
struct Found {
  Vec3<Real> direction;  // of that ray
  Hit<Real> hit;
  render::SurfacePoint<Real> point;
};

// A place that every ray of a test aims at: inside of a solid, on a flat shape.
Vec3d middle_of(const Geometry& geometry, Dice& dice, double scale) {
  if (const auto* p = std::get_if<alhazen::Plane>(&geometry)) {
    return p->offset * p->normal + scale * aside_of(p->normal, dice);
  }
  if (const auto* d = std::get_if<alhazen::Disc>(&geometry)) {
    return d->center + dice.uniform(0.6, 1.9) * scale * aside_of(d->normal, dice);
  }
  const double u = dice.uniform(0.1, 0.8), v = dice.uniform(0.1, 0.9 - u);
  if (const auto* t = std::get_if<alhazen::Triangle>(&geometry)) {
    const auto& [a, b, c] = t->corners;
    return a + u * (b - a) + v * (c - a);
  }
  if (const auto* q = std::get_if<Quad4>(&geometry)) {
    return q->corner + u * q->edge_u + v * q->edge_v;
  }
  return render::inner_point(geometry) + (0.1 * scale) * dice.direction();
}

template <class Real>
Ray<Real> aimed_ray(const Geometry& geometry, Dice& dice, double scale) {
  const Vec3d d = dice.direction(), middle = middle_of(geometry, dice, scale);
  return ray_of<Real>(middle - (dice.uniform(5, 50) * scale) * d, d);
}

template <class Real>
std::optional<Found<Real>> find(const ShapeTable<Real>& table, const Ray<Real>& ray) {
  const auto hit = closest_hit(table, ray, Source(), infinity<Real>());
  if (!hit) return std::nullopt;
  return Found<Real>{ray.direction, *hit, table.plain_surface(0, ray, hit->crossing())};
}

// Whether a ray has to meet the shape: in the oracle the very same ray does, with a margin of more
// than the 16 roundings that ray and corners may have. A triangle that is seen edge-on is no wider
// than that.
template <class Real>
bool has_to_meet(const Geometry& geometry, const Ray<Real>& ray) {
#if ALHAZEN_HAS_QUAD
  const ShapeTable<Quad> oracle({shape_of(geometry)}, Vec3d{});
  for (const auto& doubt : oracle.doubts(0, exact(ray), Departure())) {
    if (doubt.crosses && doubt.margin > static_cast<Quad>(16 * kEps<Real>)) return true;
  }
  return false;
#else
  return true;
#endif
}

struct ShadowTally {
  double shadowed = 0, not_found = 0;
  std::size_t asked = 0;
};

// Every kind alone at scale 2^k, lights all around it: those above the surface that was met reach
// it, be it told by the side that the ray came from, as the renderer does, or by the direction.
template <class Real>
void shine_on(int k, int points, Dice& dice, ShadowTally& tally) {
  const double scale = std::ldexp(1.0, k);
  for (const Geometry& geometry : every_kind(dice, scale)) {
    // Open tubes are concave from inside.
    const auto* tube = std::get_if<Cylinder>(&geometry);
    const auto* cone = std::get_if<Cone>(&geometry);
    if ((tube != nullptr && !tube->capped) || (cone != nullptr && !cone->capped)) continue;
    const ShapeTable<Real> table({shape_of(geometry)}, Vec3d{});
    for (int i = 0; i < points; ++i) {
      const Ray<Real> aimed = aimed_ray<Real>(geometry, dice, scale);
      const auto found = find(table, aimed);
      if (!found || !is_finite(found->point.position)) {
        tally.not_found += found || has_to_meet(geometry, aimed);
        continue;
      }
      const Vec3<Real> facing = found->hit.enters ? found->point.normal : -found->point.normal;
      const Vec3<Real> light(scale * dice.in_cube(std::ldexp(1.0, dice.below(7))));
      const Vec3<Real> to_light = light - found->point.position;
      if (!(dot(facing, to_light) > Real(0))) continue;
      const Real distance = length(to_light);
      const Ray<Real> ray{found->point.position, to_light / distance};
      const Source told = source_after(Source(), found->direction, found->hit, false);
      const Source untold{0, found->hit.face, Side::kByDirection};
      for (const Source& source : {told, untold}) {
        ++tally.asked;
        if (any_hit(table, ray, source, distance)) ++tally.shadowed;
      }
    }
  }
}

template <class Real>
void self_shadow(int largest) {
  ShadowTally tally;
  Dice dice(210);
  for (int k = -largest; k <= largest; k += largest / 25)
    shine_on<Real>(k, static_cast<int>(rays(200)), dice, tally);
  EXPECT_GT(tally.asked, rays(50000));
  const std::string range =
      " at 2^-" + std::to_string(largest) + " to 2^" + std::to_string(largest);
  figure_in<Real>("B1", "points in their own shape's shadow" + range, tally.shadowed, 0);
  figure_in<Real>("B1", "rays that miss what they aim at" + range, tally.not_found, 0);
}

TEST(Hard, B1_SelfShadow) {
  self_shadow<double>(300);
  // Squares of floats end at 2^+-63.
  self_shadow<float>(50);
}

// What a light adds to a white surface at the point where a ray meets it, times pi: the cosine law
// and the inverse square, or nothing where the surface faces away or something stands between.
template <class Real>
Real irradiance(const ShapeTable<Real>& table, const Found<Real>& found, Vec3<Real> light) {
  render::PointLightKernel<Real> kernel;
  kernel.position = light;
  kernel.intensity = Rgb<Real>(Real(1));
  const auto sample = kernel.sample(found.point.position);
  const Vec3<Real> facing = found.hit.enters ? found.point.normal : -found.point.normal;
  const Real cosine = dot(facing, sample.direction);
  if (is_black(sample.weight) || !(cosine > Real(0))) return Real(0);
  const Source source = source_after(Source(), found.direction, found.hit, false);
  if (any_hit(table, {found.point.position, sample.direction}, source, sample.distance)) {
    return Real(0);
  }
  return cosine * sample.weight.r;
}

// Surfaces whose point below the light is exact in any type, met straight from above.
const std::vector<Geometry> kUnderTheLight = {alhazen::Sphere{{0, 0, 0}, 1},
                                              alhazen::Box{{-1, -1, -1}, {1, 1, 1}},
                                              Cylinder{{0, -1, 0}, {0, 1, 0}, 1, true},
                                              Cylinder{{0, 0, -1}, {0, 0, 1}, 1, true},
                                              Cone{{0, -1, 0}, {0, 1, 0}, 1, 0.5, true},
                                              alhazen::Plane{{0, 1, 0}, 1},
                                              alhazen::Disc{{0, 1, 0}, {0, 1, 0}, 1, 0},
                                              Quad4{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}}};

template <class Real>
void near_lights() {
  double worst = 0, lit_behind = 0, not_finite = 0;
  Dice dice(250);
  for (const Geometry& geometry : kUnderTheLight) {
    const ShapeTable<Real> table({shape_of(geometry)}, Vec3d{});
    const Ray<Real> down = ray_of<Real>({0, 3, 0}, {0, -1, 0});
    const auto hit = closest_hit(table, down, Source(), infinity<Real>());
    ASSERT_TRUE(hit);
    const Found<Real> found{down.direction, *hit, table.plain_surface(0, down, hit->crossing())};
    ASSERT_EQ(found.point.position, Vec3<Real>(Vec3d{0, 1, 0})) << kind_name(geometry);
    // h above it and s aside: cos = h / r, and 1 / r^2. y = 1 + h is rounded, so the height that
    // the light really has is what counts; a light that rounds to the surface itself is on it.
    for (std::size_t i = 0; i < rays(2000); ++i) {
      const double h = std::pow(10.0, dice.uniform(-13, 0)), s = h * dice.uniform(0, 10);
      const Vec3<Real> light(Vec3d{s, 1 + h, 0});
      const double height = static_cast<double>(light.y) - 1, aside = static_cast<double>(light.x);
      const double squared = height * height + aside * aside;
      const Real got = irradiance(table, found, light);
      if (!is_finite(got)) ++not_finite;
      const double expected = height / (squared * std::sqrt(squared));
      if (height > 0) worst = larger(worst, std::abs(static_cast<double>(got) / expected - 1));
      if (!(height > 0) && got != Real(0)) ++lit_behind;
      // Behind the surface, inside of the solid or below the sheet, at the same distance.
      const Real behind = irradiance(table, found, Vec3<Real>(Vec3d{s, 1 - h, 0}));
      if (!is_finite(behind)) ++not_finite;
      if (behind != Real(0)) ++lit_behind;
    }
    // On it, at the very point and beside it.
    for (const double s : {0.0, 1e-12, 0.25}) {
      const Real on = irradiance(table, found, Vec3<Real>(Vec3d{s, 1, 0}));
      if (!is_finite(on)) ++not_finite;
      if (on != Real(0)) ++lit_behind;
    }
  }
  figure_in<Real>("B5", "answers that are not finite", not_finite, 0);
  figure_in<Real>("B5", "lights on, in and behind the surface that reach it", lit_behind, 0);
  figure_in<Real>("B5", "relative error of cos / r^2, lights 1e-13 to 1 above", worst, 1e-9, "",
                  "a float has an error of 2^-24 = 6e-8");
}

TEST(Hard, B5_NearLights) {
  near_lights<double>();
  near_lights<float>();
}

// The sphere of 16 x 8 cells as triangles with the sphere's normals at the corners, as Alhazen has
// it: the light falls by the smooth normal, but only on what the true surface, which is flat, turns
// to the light; a triangle that faces away is dark however its normals bend. No point of a convex
// mesh is in the shadow of another triangle. So the terminator follows the edges of the triangles;
// how much of the surface it takes is the figure. It is geometry, not rounding: the two normals are
// up to half of a cell's diagonal apart, 16 degrees. First measured: 0.94 % of 6400 points; the
// bound is more than four standard deviations above.
template <class Real>
double darkened_share(double& shadowed_by_others) {
  constexpr int kAround = 16, kUp = 8;
  const auto corner = [](int i, int j) {
    const SinCos<double> around = sin_cos_of_turns(i % kAround * (1.0 / kAround));
    const SinCos<double> up = sin_cos_of_turns(j * (0.5 / kUp) - 0.25);
    return Vec3d{up.cos * around.cos, up.sin, up.cos * around.sin};
  };
  std::vector<Shape> shapes;
  const auto add = [&](Vec3d a, Vec3d b, Vec3d c) {
    shapes.push_back(shape_of(alhazen::Triangle{{a, b, c}, {{a, b, c}}}));
  };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kUp; ++j) {
      const Vec3d a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                  d = corner(i, j + 1);
      if (j > 0) add(a, c, b);
      if (j < kUp - 1) add(a, d, c);
    }
  }
  const ShapeTable<Real> table(shapes, Vec3d{});
  double lit_by_normal = 0, dark = 0;
  Dice dice(270);
  for (std::size_t n = 0; n < rays(10000); ++n) {
    const Vec3d d = dice.direction(), light = dice.direction();
    const Ray<Real> ray = ray_of<Real>(0.8 * aside_of(d, dice) - 4.0 * d, d);
    const auto hit = closest_hit(table, ray, Source(), infinity<Real>());
    if (!hit) continue;
    const auto point = table.plain_surface(hit->shape, ray, hit->crossing());
    const Vec3<Real> to_light(light);
    const Real side = hit->enters ? Real(1) : Real(-1);
    if (!(side * dot(point.shading_normal, to_light) > Real(0.1))) continue;
    ++lit_by_normal;
    if (!(side * dot(point.normal, to_light) > Real(0))) {
      ++dark;
      continue;
    }
    const Source source = source_after(Source(), ray.direction, *hit, false);
    if (any_hit(table, {point.position, to_light}, source, infinity<Real>())) ++shadowed_by_others;
  }
  return dark / lit_by_normal;
}

template <class Real>
void terminator() {
  double shadowed_by_others = 0;
  const double dark = darkened_share<Real>(shadowed_by_others);
  figure_in<Real>("B7", "points of a smooth convex mesh in the shadow of its own triangles",
                  shadowed_by_others, 0);
  figure_in<Real>("B7", "share of points with n_s.l > 0.1 that the flat triangle keeps dark", dark,
                  0.015);
}

TEST(Hard, B7_ShadowTerminator) {
  terminator<double>();
  terminator<float>();
}

}  // namespace
}  // namespace alhazen::hard
