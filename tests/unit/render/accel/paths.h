// One ray, through a tree and by the loop over all shapes. Shapes is a ShapeTable or the
// WorldShapes, Tree is its tree.
#pragma once

#include "render/accel/closest_hit.h"
#include "unit/render/accel/support.h"

namespace alhazen::render {

// Follows a ray through a scene in both ways: closest hits, the walk along each line, shadow rays,
// and what is reflected or goes through. The number of hits.
template <class Shapes, class Tree, class Real>
int compare_path(const Shapes& table, const Tree& tree, Ray<Real> ray, Dice& dice, int bounces) {
  const Real inf = infinity<Real>();
  Source source;
  int hits = 0;
  for (int bounce = 0; bounce < bounces; ++bounce) {
    const auto expected = closest_hit(table, ray, source, inf);
    expect_same(closest_hit(tree, ray, source, inf), expected);
    if (testing::Test::HasFailure()) return hits;
    auto on_line = expected;
    for (int step = 0; step < 6 && on_line; ++step) {
      const auto next = next_hit(table, ray, source, *on_line, inf);
      expect_same(next_hit(tree, ray, source, *on_line, inf), next);
      on_line = next;
    }
    if (!expected) {
      EXPECT_FALSE(any_hit(tree, ray, source, inf));
      return hits;
    }
    ++hits;
    // Just before the hit, at the hit, and beyond it; with the shape itself ignored.
    const Real factor = Real(1) - 4 * ScalarTraits<Real>::unit_roundoff();
    for (const Real t_max : {expected->t * factor, expected->t, 2 * expected->t}) {
      EXPECT_EQ(any_hit(tree, ray, source, t_max), any_hit(table, ray, source, t_max));
      const ShapeId lamp = expected->shape;
      EXPECT_EQ(any_hit(tree, ray, source, t_max, lamp), any_hit(table, ray, source, t_max, lamp));
    }
    const auto point = table.plain_surface(expected->shape, ray, expected->crossing());
    const bool across = dice.below(2) == 0;
    source = source_after(source, ray.direction, *expected, across);
    ray.origin = point.position;
    if (!across) ray.direction = reflected(ray.direction, point.normal);
  }
  return hits;
}

}  // namespace alhazen::render
