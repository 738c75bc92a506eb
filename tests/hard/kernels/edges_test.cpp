// A5 and A7: origins on centres, surfaces, axes and tips; rays through edges, corners and rims.
#include <gtest/gtest.h>

#include "hard/kernels/zoo.h"

namespace alhazen::hard {
namespace {

constexpr Side kNoSide = Side::kByDirection;

struct Question {
  Geometry geometry;
  Vec3d origin, direction;
  Departure from;
  std::vector<double> t;  // the answer
};

std::vector<Question> questions(double r) {
  using namespace render::frustum;
  const Departure anywhere, above{0, Side::kAbove}, below{0, Side::kBelow}, leaving{0, kNoSide};
  const alhazen::Sphere ball{{0, 0, 0}, r};
  const alhazen::Box box{{-r, -r, -r}, {r, r, r}};
  const Cylinder tube{{0, 0, 0}, {0, 4 * r, 0}, r, true};
  const Cone tip{{0, 0, 0}, {0, 2 * r, 0}, 2 * r, 0, true};  // half angle 45 degrees
  const alhazen::Plane ground{{0, 1, 0}, r};
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  return {
      // From the middle.
      {ball, {}, x, anywhere, {r}},
      {ball, {}, -z, anywhere, {r}},
      {box, {}, -y, anywhere, {r}},
      {box, {}, {1, 1, 1}, anywhere, {r}},
      {tube, {0, r, 0}, x, anywhere, {r}},
      {tube, {0, r, 0}, y, anywhere, {3 * r}},
      {tube, {0, r, 0}, -y, anywhere, {r}},
      {tip, {0, r, 0}, z, anywhere, {r}},
      {tip, {0, r, 0}, y, anywhere, {r}},
      // On the surface, by chance: the root at 0 counts.
      {ball, {r, 0, 0}, -x, anywhere, {0, 2 * r}},
      {box, {r, 0, 0}, -x, anywhere, {0, 2 * r}},
      {box, {r, r, r}, {-1, -1, -1}, anywhere, {0, 2 * r}},
      {tube, {r, r, 0}, -x, anywhere, {0, 2 * r}},
      {tube, {0, 0, 0}, y, anywhere, {0, 4 * r}},
      {tip, {0, 2 * r, 0}, -y, anywhere, {0, 2 * r}},
      {ground, {0, r, 0}, -y, anywhere, {0}},
      // On the surface, leaving it: the root at 0 does not count.
      {ball, {r, 0, 0}, -x, leaving, {2 * r}},
      {ball, {r, 0, 0}, x, leaving, {}},
      {ball, {r, 0, 0}, y, above, {}},
      {ball, {r, 0, 0}, y, below, {0}},
      {box, {r, 0, 0}, -x, {1, kNoSide}, {2 * r}},
      {box, {r, 0, 0}, y, {1, Side::kAbove}, {}},
      {box, {r, 0, 0}, y, {1, Side::kBelow}, {r}},
      {tube, {r, r, 0}, -x, {kSide, kNoSide}, {2 * r}},
      {tube, {r, r, 0}, x, {kSide, kNoSide}, {}},
      {tube, {r, r, 0}, y, {kSide, Side::kAbove}, {}},
      {tube, {0, 0, 0}, y, {kSmallCap, kNoSide}, {4 * r}},
      {tube, {0, 0, 0}, -y, {kSmallCap, kNoSide}, {}},
      {tip, {r, r, 0}, -x, {kSide, kNoSide}, {2 * r}},
      {tip, {0, 2 * r, 0}, -y, {kSide, Side::kBelow}, {2 * r}},
      {tip, {0, 2 * r, 0}, y, {kSide, Side::kAbove}, {}},
      {ground, {0, r, 0}, -y, leaving, {}},
      // A tangent touches: in and out at one point.
      {ball, {r, 0, -2 * r}, z, anywhere, {2 * r, 2 * r}},
      // Through the tip from the side, and along the axis from above it.
      {tip, {-3 * r, 2 * r, 0}, x, anywhere, {3 * r, 3 * r}},
      {tip, {0, 5 * r, 0}, -y, anywhere, {3 * r, 5 * r}},
      // The second nappe is not there.
      {tip, {-3 * r, 3 * r, 0}, x, anywhere, {}},
  };
}

template <class Real>
void special_origins() {
  double wrong = 0;
  // Floats, so that the numbers are the same in both types; so short that 5 r is exact.
  for (const double r : {1.0, 3.0, 0x1.99p-4, 0x1.e84p19, 0x1.0cp-20}) {
    int number = 0;
    for (const Question& q : questions(r)) {
      const ShapeTable<Real> table({shape_of(q.geometry)}, Vec3d{});
      const auto hits = table.crossings(0, ray_of<Real>(q.origin, q.direction), q.from);
      bool right = hits.size() == static_cast<int>(q.t.size());
      for (int i = 0; right && i < hits.size(); ++i)
        right = hits[i].t == static_cast<Real>(q.t[static_cast<std::size_t>(i)]);
      ++number;
      EXPECT_TRUE(right) << "question " << number << ", " << kind_name(q.geometry) << ", r = " << r;
      if (!right) ++wrong;
    }
  }
  figure_in<Real>("A5", "answers from special origins that are not exact", wrong, 0);
}

TEST(Hard, A5_SpecialOrigins) {
  special_origins<double>();
  special_origins<float>();
}

// A7. From outside every ray crosses a closed solid twice or not at all, from inside once; and a
// ray that went in by one crossing, leaving from there, comes out once.
template <class Real>
void parity() {
  const std::vector<Geometry> solids = {
      alhazen::Box{{-1, -1, -1}, {1, 1, 1}}, Cylinder{{0, -1, 0}, {0, 1, 0}, 1, true},
      Cone{{0, -1, 0}, {0, 1, 0}, 1, 0, true}, Cone{{0, -1, 0}, {0, 1, 0}, 0.5, 1, true},
      alhazen::Sphere{{0, 0, 0}, 1}};
  const ShapeTable<Real> table(shapes_of(solids), Vec3d{});
  double odd = 0, no_way_out = 0, not_inside = 0;
  std::size_t met = 0;
  Dice dice(70);
  for (std::size_t i = 0; i < rays(100000); ++i) {
    // Corners, edges and middles of faces of the box, points of the rims, tips.
    Vec3d target{double(dice.below(3) - 1), double(dice.below(3) - 1), double(dice.below(3) - 1)};
    if (i % 2 == 0) {
      const SinCos<double> p = sin_cos_of_turns(dice.uniform(0, 1));
      target = {p.cos, target.y, p.sin};
    }
    const Vec3d d = i % 3 == 0 ? dice.direction() : normalized(target - dice.in_cube(4));
    const Ray<Real> ray = ray_of<Real>(target - 8.0 * d, d);
    const Ray<Real> from_inside = ray_of<Real>({}, target == Vec3d() ? d : target);
    for (ShapeId id = 0; id < table.size(); ++id) {
      if (table.crossings(id, from_inside, Departure()).size() != 1) ++not_inside;
      const auto hits = table.crossings(id, ray, Departure());
      if (hits.size() % 2 != 0) ++odd;
      if (hits.size() == 0) continue;
      ++met;
      const auto point = table.plain_surface(id, ray, hits[0]);
      const auto out = table.crossings(id, {point.position, ray.direction},
                                       Departure{hits[0].face, Side::kBelow});
      if (out.size() != 1 || out[0].enters) ++no_way_out;
    }
  }
  EXPECT_GT(met, rays(100000));
  figure_in<Real>("A7", "odd numbers of crossings at edges, corners and rims", odd, 0);
  figure_in<Real>("A7", "rays from inside that do not cross once", not_inside, 0);
  figure_in<Real>("A7", "rays that went in and do not come out", no_way_out, 0);
}

TEST(Hard, A7_EdgesCornersRims) {
  parity<double>();
  parity<float>();
}

}  // namespace
}  // namespace alhazen::hard
