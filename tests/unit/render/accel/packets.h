// Packets of rays, through a tree and by the loop over all shapes. Shapes is a ShapeTable or the
// WorldShapes, Tree is its tree.
#pragma once

#include "render/accel/closest_hit.h"
#include "render/accel/shape_tree_lanes.h"
#include "unit/render/accel/support.h"

namespace alhazen::render {

// Single rays, which lanes are made of and compared with.
template <class L>
struct Rays {
  using Real = ScalarOf<L>;
  static constexpr auto kCount = static_cast<std::size_t>(L::kWidth);

  std::array<Ray<Real>, kCount> ray;
  std::array<Source, kCount> source{};
  std::array<Real, kCount> t_max;
  std::array<ShapeId, kCount> ignored;
  std::uint32_t active = ~0U;

  Rays() {
    t_max.fill(infinity<Real>());
    ignored.fill(kNoId);
  }
  bool is_active(std::size_t i) const { return ((active >> i) & 1U) != 0; }

  Ray<L> lanes() const {
    Ray<L> result;
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < kCount; ++i) {
        result.origin[axis].set(static_cast<int>(i), ray[i].origin[axis]);
        result.direction[axis].set(static_cast<int>(i), ray[i].direction[axis]);
      }
    }
    return result;
  }
  DepartureLanes<L> departures() const {
    using Word = ScalarOf<IntOf<L>>;
    DepartureLanes<L> from;
    for (std::size_t i = 0; i < kCount; ++i) {
      const int lane = static_cast<int>(i);
      from.shape.set(lane,
                     source[i].shape == kNoId ? Word(-1) : static_cast<Word>(source[i].shape));
      from.face.set(lane, static_cast<Word>(source[i].face));
      from.side.set(lane, static_cast<Word>(source[i].side));
    }
    return from;
  }
  template <class To, class From>
  static To each(const std::array<From, kCount>& of) {
    To result;
    for (std::size_t i = 0; i < kCount; ++i) {
      using Word = ScalarOf<To>;
      const bool none = std::is_same_v<From, ShapeId> && of[i] == static_cast<From>(kNoId);
      result.set(static_cast<int>(i), none ? Word(-1) : static_cast<Word>(of[i]));
    }
    return result;
  }
};

template <class L>
inline void expect_lane(const HitLanes<L>& found, std::size_t i,
                        const std::optional<Hit<ScalarOf<L>>>& expected) {
  const int lane = static_cast<int>(i);
  std::optional<Hit<ScalarOf<L>>> hit;
  if (found.found[lane]) hit = found[lane];
  expect_same(hit, expected);
}

// All that can be asked of these rays; the number of hits. The first hits stay in `hits`.
template <class L, class Shapes, class Tree>
int compare(const Shapes& table, const Tree& tree, const Rays<L>& rays,
            std::array<std::optional<Hit<ScalarOf<L>>>, Rays<L>::kCount>& hits) {
  using Real = ScalarOf<L>;
  const auto source_of = [&](int lane) -> const Source& {
    return rays.source[static_cast<std::size_t>(lane)];
  };
  const Ray<L> ray = rays.lanes();
  const DepartureLanes<L> from = rays.departures();
  const auto t_max = Rays<L>::template each<L>(rays.t_max);
  const auto ignored = Rays<L>::template each<IntOf<L>>(rays.ignored);
  const auto active = MaskOf<L>::from_bits(rays.active);
  HitLanes<L> found = closest_hits(tree, ray, from, source_of, t_max, ignored, active);
  int count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    hits[i].reset();
    if (rays.is_active(i))
      hits[i] = closest_hit(table, rays.ray[i], rays.source[i], rays.t_max[i], rays.ignored[i]);
    expect_lane(found, i, hits[i]);
    count += hits[i] ? 1 : 0;
  }
  auto on_line = hits;
  for (int step = 0; step < 3; ++step) {
    const HitLanes<L> next =
        next_hits(tree, ray, from, source_of, found, t_max, ignored, found.found);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (on_line[i]) {
        on_line[i] = next_hit(table, rays.ray[i], rays.source[i], *on_line[i], rays.t_max[i],
                              rays.ignored[i]);
      }
      expect_lane(next, i, on_line[i]);
    }
    found = next;
  }
  // Just before each hit, at it, and beyond.
  const Real factor = Real(1) - 4 * ScalarTraits<Real>::unit_roundoff();
  for (int k = 0; k < 3; ++k) {
    auto limits = rays.t_max;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (hits[i]) limits[i] = k == 0 ? hits[i]->t * factor : Real(k) * hits[i]->t;
    }
    const MaskOf<L> blocked =
        any_hits(tree, ray, from, source_of, Rays<L>::template each<L>(limits), ignored, active);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(blocked[static_cast<int>(i)],
                rays.is_active(i) &&
                    any_hit(table, rays.ray[i], rays.source[i], limits[i], rays.ignored[i]))
          << i;
    }
  }
  return count;
}

// Follows the rays together: through surfaces or back from them, some with a shape to ignore, some
// with an end, some left out.
template <class L, class Shapes, class Tree>
int compare_paths(const Shapes& table, const Tree& tree, Rays<L> rays, Dice& dice, int bounces) {
  using Real = ScalarOf<L>;
  int count = 0;
  for (int bounce = 0; bounce < bounces && rays.active != 0; ++bounce) {
    std::array<std::optional<Hit<Real>>, Rays<L>::kCount> hits;
    count += compare(table, tree, rays, hits);
    if (testing::Test::HasFailure()) return count;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      rays.t_max[i] = infinity<Real>();
      rays.ignored[i] = kNoId;
      if (!hits[i]) {
        rays.active &= ~(1U << i);
        continue;
      }
      const auto point = table.plain_surface(hits[i]->shape, rays.ray[i], hits[i]->crossing());
      const bool across = dice.below(2) == 0;
      rays.source[i] = source_after(rays.source[i], rays.ray[i].direction, *hits[i], across);
      rays.ray[i].origin = point.position;
      if (!across) rays.ray[i].direction = reflected(rays.ray[i].direction, point.normal);
      if (dice.below(4) == 0)
        rays.ignored[i] = static_cast<ShapeId>(dice.below(static_cast<int>(table.size())));
      if (dice.below(4) == 0) rays.t_max[i] = static_cast<Real>(dice.uniform(0, 2)) * hits[i]->t;
      if (dice.below(8) == 0) rays.source[i] = Source();
    }
  }
  return count;
}

// From one point into a narrow cone, as a camera sends them; across an axis, so that the packet has
// directions of both signs.
template <class L>
Rays<L> narrow_rays(Dice& dice, double scale) {
  using Real = ScalarOf<L>;
  Rays<L> rays;
  const Vec3d from = scale * dice.in_cube(5);
  Vec3d middle = dice.below(2) == 0 ? dice.direction() : normalized(-from);
  if (dice.below(4) == 0) middle[dice.below(3)] = 0;
  for (auto& ray : rays.ray)
    ray = {Vec3<Real>(from), Vec3<Real>(middle + dice.in_cube(0.02))};
  if (dice.below(2) == 0) rays.active = static_cast<std::uint32_t>(dice.below(1 << 16));
  return rays;
}

}  // namespace alhazen::render
