// Queues in columns: what is put in comes out, and cutting a generation keeps each sample's order.
#include <gtest/gtest.h>
#include <map>

#include "render/wave/hit_queue.h"
#include "render/wave/waiting_rays.h"
#include "unit/render/wave/push_ray.h"

namespace alhazen::render {
namespace {

void push(RayQueue<double>& rays, SlotId slot, std::uint64_t name, const Source& source = {}) {
  const double x = static_cast<double>(name);
  push_ray(rays, {{{x, x + 0.25, x + 0.5}, {-x, 1, x}},
                  source,
                  Rgb<double>(x, 2 * x, 3 * x),
                  slot,
                  static_cast<MediumId>(name + 1),
                  name,
                  5,
                  6});
}

Source corner(int k) {
  Source source{7, 2, Side::kAbove, {0.1, 0.2, 0.3 * k}};
  source.remember({3, k, Side::kBelow});
  source.remember({4, k, Side::kAbove});
  return source;
}

// As children of one kind move up to those of another.
TEST(RayQueue, ClosesGaps) {
  RayQueue<double> rays;
  for (int k = 0; k < 40; ++k)
    push(rays, static_cast<SlotId>(k), static_cast<std::uint64_t>(k), corner(k));
  rays.close_gap(10, 25, 12);  // the new place and the old one overlap
  ASSERT_EQ(rays.size(), 22u);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::size_t was = i < 10 ? i : i + 15;
    EXPECT_EQ(rays.ray(i).origin.x, static_cast<double>(was));
    EXPECT_EQ(rays.path[i], was);
    EXPECT_EQ(rays.slot[i], static_cast<std::int64_t>(was));
    EXPECT_EQ(rays.source[i].earlier[1].face, static_cast<int>(was));
  }
}

TEST(RayQueue, GivesBackWhatWasPutIn) {
  RayQueue<double> rays;
  for (int k = 0; k < 1000; ++k)
    push(rays, 1, static_cast<std::uint64_t>(k), k % 3 == 0 ? corner(k) : Source());
  ASSERT_EQ(rays.size(), 1000u);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double x = static_cast<double>(i);
    EXPECT_EQ(rays.ray(i).origin, Vec3d(x, x + 0.25, x + 0.5));
    EXPECT_EQ(rays.direction[i], Vec3d(-x, 1, x));
    EXPECT_EQ(rays.weight[i], Rgbd(x, 2 * x, 3 * x));
    EXPECT_EQ(rays.medium[i], static_cast<MediumId>(i + 1));
    const Source expected = i % 3 == 0 ? corner(static_cast<int>(i)) : Source();
    const Source source = rays.source[i];
    EXPECT_EQ(source.shape, expected.shape);
    EXPECT_EQ(source.face, expected.face);
    EXPECT_EQ(source.side, expected.side);
    EXPECT_EQ(source.arrival, expected.arrival);
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_EQ(source.earlier[j].shape, expected.earlier[j].shape);
      EXPECT_EQ(source.earlier[j].face, expected.earlier[j].face);
      EXPECT_EQ(source.earlier[j].side, expected.earlier[j].side);
    }
  }
}

TEST(RayQueue, KeepsItsMemory) {
  RayQueue<float> rays;
  const auto fill = [&rays] {
    for (int k = 0; k < 500; ++k)
      push_ray(rays, {});
  };
  fill();
  const float* const place = rays.origin.x.data();
  rays.clear();
  EXPECT_TRUE(rays.empty());
  fill();
  EXPECT_EQ(rays.origin.x.data(), place);
}

TEST(HitQueue, GivesBackWhatWasPutIn) {
  HitQueue<float> hits;
  hits.make_room(3);
  hits.push(2, {1.5F, 9, 1, true});
  hits.push(5, {0.0F, 0, kNoFace, false});
  EXPECT_EQ(hits.size(), 2u);
  EXPECT_EQ(hits.ray_of(1), 5u);
  EXPECT_EQ(hits.hit[0].t, 1.5F);
  EXPECT_EQ(hits.hit[0].shape, 9u);
  EXPECT_TRUE(hits.hit[0].enters);
  EXPECT_EQ(hits.hit[1].face, kNoFace);
  EXPECT_FALSE(hits.hit[1].enters);
}

// Follows all parts of a generation; the names of the rays in the order of their turn.
std::map<SlotId, std::vector<std::uint64_t>> turns(WaitingRays<double>& waiting,
                                                   RayQueue<double>& rays, std::size_t slots,
                                                   std::size_t* largest) {
  std::map<SlotId, std::vector<std::uint64_t>> names;
  for (*largest = 0;; waiting.resume(rays)) {
    waiting.set_aside(rays, slots);
    *largest = std::max(*largest, rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      names[rays.slot[i]].push_back(rays.path[i]);
    if (waiting.empty()) return names;
  }
}

TEST(WaitingRays, KeepTheOrderOfEachSample) {
  constexpr SlotId kSlots = 40;
  RayQueue<double> rays;
  for (std::uint64_t k = 0; k < 800; ++k)
    push(rays, static_cast<SlotId>(k * 7 % kSlots), k);
  WaitingRays<double> waiting(64, 1000);
  std::size_t largest = 0;
  const auto names = turns(waiting, rays, kSlots, &largest);
  EXPECT_LE(largest, 64u);
  ASSERT_EQ(names.size(), kSlots);
  for (const auto& [slot, of_slot] : names) {
    EXPECT_EQ(of_slot.size(), 20u);
    EXPECT_TRUE(std::is_sorted(of_slot.begin(), of_slot.end()));
  }
}

// 300 rays of one sample, of which at most 100 are followed at once: at the same places whatever
// is comfortable, and whatever else is there.
TEST(WaitingRays, CutOneSampleByItsOwnSizeAlone) {
  for (const std::size_t comfortable : {std::size_t{1}, std::size_t{50}, std::size_t{100}}) {
    for (const bool crowd : {false, true}) {
      RayQueue<double> rays;
      for (std::uint64_t k = 0; k < 300; ++k) {
        push(rays, 1, k);
        if (crowd) push(rays, static_cast<SlotId>(2 * (k % 2)), k);
      }
      WaitingRays<double> waiting(comfortable, 100);
      std::vector<std::size_t> parts;
      for (;; waiting.resume(rays)) {
        waiting.set_aside(rays, 3);
        const bool whole = rays.slot[0] == 1;
        if (whole) parts.push_back(rays.size());
        if (waiting.empty()) break;
      }
      EXPECT_EQ(parts, (std::vector<std::size_t>{100, 100, 100})) << comfortable << crowd;
    }
  }
}

TEST(WaitingRays, LeaveAComfortableGenerationAlone) {
  RayQueue<double> rays;
  for (const SlotId slot : {3, 1, 2, 1})
    push(rays, slot, 10 + slot);
  WaitingRays<double> waiting(4, 4);
  waiting.set_aside(rays, 4);
  EXPECT_TRUE(waiting.empty());
  EXPECT_EQ(rays.slot[0], 3u);
}

}  // namespace
}  // namespace alhazen::render
