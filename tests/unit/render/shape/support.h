// Random shapes, points and directions for the tests of render/shape and render/accel.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/hash.h"
#include "render/shape/shape_table.h"

namespace alhazen::render {

constexpr double kU = 0x1p-53;  // unit roundoff of double

// A stream of numbers that is the same on every run.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(mix_64(seed + 0x5eed)) {}

  double uniform(double from, double to) {
    state_ = mix_64(state_, 1);
    return from + (to - from) * (static_cast<double>(state_ >> 11) * 0x1p-53);
  }
  int below(int count) { return static_cast<int>(uniform(0, count)); }
  Vec3d in_cube(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v = in_cube(1);
      if (const double squared = dot(v, v); squared > 0.01 && squared < 1) return normalized(v);
    }
  }

 private:
  std::uint64_t state_;
};

inline Shape shape_of(const Geometry& geometry) {
  Shape shape;
  shape.geometry = geometry;
  return shape;
}

inline Shape shape_of(const Geometry& geometry, const Affined& world_from_object) {
  Shape shape = shape_of(geometry);
  shape.world_from_object = world_from_object;
  return shape;
}

// The closed convex kinds, at random, with all their lengths times `scale`.
inline std::vector<Geometry> random_solids(Dice& dice, double scale) {
  const auto length_of = [&](double from, double to) { return scale * dice.uniform(from, to); };
  const Vec3d center = scale * dice.in_cube(2), corner = scale * dice.in_cube(2);
  const Vec3d axis = length_of(0.3, 3) * dice.direction();
  const double wide = length_of(0.3, 2), narrow = wide * dice.uniform(0.1, 0.9);
  return {
      alhazen::Sphere{center, wide},
      alhazen::Box{corner, corner + Vec3d{length_of(0.2, 2), length_of(0.2, 2), length_of(0.2, 2)}},
      Cylinder{center, center + axis, wide, true}, Cone{center, center + axis, wide, 0, true},
      Cone{center, center + axis, narrow, wide, true}};
}

// A point well inside of a solid from random_solids.
inline Vec3d inner_point(const Geometry& geometry) {
  if (const auto* s = std::get_if<alhazen::Sphere>(&geometry)) return s->center;
  if (const auto* b = std::get_if<alhazen::Box>(&geometry)) return b->min + 0.5 * (b->max - b->min);
  if (const auto* c = std::get_if<Cylinder>(&geometry)) return c->base + 0.5 * (c->top - c->base);
  const auto& c = std::get<Cone>(geometry);
  return c.base + 0.5 * (c.top - c.base);
}

// Mirror reflection.
template <class Real>
inline Vec3<Real> reflected(Vec3<Real> d, Vec3<Real> n) {
  return multiply_add(Real(-2) * dot(n, d), n, d);
}

}  // namespace alhazen::render
