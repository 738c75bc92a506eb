// A4 and A6: directions of any length, and along the axes, where a component is a zero of either
// sign.
#include <cmath>
#include <gtest/gtest.h>

#include "hard/kernels/zoo.h"

namespace alhazen::hard {
namespace {

// Rays whose direction times 2^k, for any |k| <= largest, gives anything but t times 2^-k.
template <class Real>
double changed_by_length(int largest) {
  std::size_t changed = 0;
  Dice dice(40);
  for (std::size_t round = 0; round < rays(50); ++round) {
    const std::vector<Geometry> kinds = every_kind(dice, 1);
    const ShapeTable<Real> table(shapes_of(kinds), Vec3d{});
    for (int i = 0; i < 5; ++i) {
      const Ray<Real> ray = ray_of<Real>(dice.in_cube(3), dice.direction());
      for (ShapeId id = 0; id < table.size(); ++id) {
        const auto plain = table.crossings(id, ray, Departure());
        for (int k = -largest; k <= largest; ++k) {
          const Real stretch = static_cast<Real>(std::ldexp(1.0, k));
          const auto stretched =
              table.crossings(id, {ray.origin, stretch * ray.direction}, Departure());
          if (!same_bits(plain, stretched, stretch)) ++changed;
        }
      }
    }
  }
  return static_cast<double>(changed);
}

TEST(Hard, A4_DirectionLength) {
  figure_in<double>("A4", "answers changed by a direction times 2^k, |k| <= 100",
                    changed_by_length<double>(100), 0);
  figure_in<float>("A4", "answers changed by a direction times 2^k, |k| <= 20",
                   changed_by_length<float>(20), 0);
  figure_in<float>("A4", "answers changed by a direction times 2^k, |k| <= 100",
                   changed_by_length<float>(100), 0, "",
                   "the square of 2^100 is no float, nor is the second word of that of 2^-50");
}

// Everything that has a face, an axis or an edge along an axis of the world.
std::vector<Geometry> aligned_kinds() {
  return {alhazen::Sphere{{0, 0, 0}, 1},
          alhazen::Box{{-1, -1, -1}, {1, 1, 1}},
          Cylinder{{0, -1, 0}, {0, 1, 0}, 1, true},
          Cylinder{{-1, 0, 0}, {1, 0, 0}, 1, false},
          Cone{{0, 0, -1}, {0, 0, 1}, 1, 0, true},
          Cone{{0, -1, 0}, {0, 1, 0}, 0.5, 1, false},
          alhazen::Plane{{0, 1, 0}, 1},
          alhazen::Disc{{0, 0, 0}, {0, 0, 1}, 1, 0.5},
          alhazen::Triangle{{Vec3d{-1, 0, -1}, Vec3d{1, 0, -1}, Vec3d{0, 0, 1}}, {}},
          Quad4{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}};
}

struct AxisTally {
  double changed = 0, not_numbers = 0, wrong_boxes = 0, cast = 0;
};

// Origins on a grid through the faces, edges, corners and axes; directions along each axis, with
// all signs of the two zeros.
template <class Real>
AxisTally along_the_axes() {
  AxisTally tally;
  const std::vector<Geometry> kinds = aligned_kinds();
  const ShapeTable<Real> table(shapes_of(kinds), Vec3d{});
  const Real zeros[] = {Real(0), -Real(0)};
  constexpr int kCells = 17;
  for (int cell = 0; cell < kCells * kCells * kCells; ++cell) {
    const auto place = [](int i) { return Real(i - 8) / Real(4); };  // -2 to 2 in quarters
    const Vec3<Real> origin{place(cell % kCells), place(cell / kCells % kCells),
                            place(cell / kCells / kCells)};
    for (int way = 0; way < 6; ++way) {
      const int axis = way / 2;
      for (ShapeId id = 0; id < table.size(); ++id) {
        Crossings<Real> first;
        for (int signs = 0; signs < 4; ++signs) {
          Vec3<Real> d;
          d[axis] = way % 2 == 0 ? Real(1) : Real(-1);
          d[(axis + 1) % 3] = zeros[signs % 2];
          d[(axis + 2) % 3] = zeros[signs / 2];
          const auto hits = table.crossings(id, {origin, d}, Departure());
          ++tally.cast;
          if (signs == 0) first = hits;
          if (!same_bits(first, hits)) ++tally.changed;
          for (const Crossing<Real>& hit : hits) {
            const auto point = table.surface(id, {origin, d}, hit);
            const bool numbers = is_finite(hit.t) && is_finite(point.position) &&
                                 is_finite(point.normal) && is_finite(point.shading_normal) &&
                                 is_finite(point.u) && is_finite(point.v);
            if (!numbers) ++tally.not_numbers;
          }
          if (!std::holds_alternative<alhazen::Box>(kinds[id])) continue;
          const auto is_within = [](Real x) { return Real(-1) <= x && x <= Real(1); };
          const Real from = origin[axis] * d[axis];
          const bool beside =
              !is_within(origin[(axis + 1) % 3]) || !is_within(origin[(axis + 2) % 3]);
          const int expected = beside || from > Real(1) ? 0 : from > Real(-1) ? 1 : 2;
          const bool right = hits.size() == expected &&
                             (expected == 0 || hits[expected - 1].t == Real(1) - from) &&
                             (expected != 2 || hits[0].t == Real(-1) - from);
          if (!right) ++tally.wrong_boxes;
        }
      }
    }
  }
  return tally;
}

template <class Real>
void axis_parallel() {
  const AxisTally tally = along_the_axes<Real>();
  EXPECT_GT(tally.cast, 1e6);
  figure_in<Real>("A6", "answers changed by the sign of a zero", tally.changed, 0);
  figure_in<Real>("A6", "answers that are not finite", tally.not_numbers, 0);
  figure_in<Real>("A6", "wrong answers of a box, face planes included", tally.wrong_boxes, 0);
}

TEST(Hard, A6_AxisParallel) {
  axis_parallel<double>();
  axis_parallel<float>();
}

}  // namespace
}  // namespace alhazen::hard
