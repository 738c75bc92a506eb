#include "render/wave/media.h"

#include <gtest/gtest.h>

namespace alhazen::render {
namespace {

TEST(MediumPool, VacuumHoldsNothing) {
  MediumPool pool(8);
  EXPECT_EQ(pool.current(kVacuum, {}), kNoId);
  EXPECT_EQ(pool.leave(kVacuum, 3), kVacuum);
}

TEST(MediumPool, LastEnteredOfEqualPriorityIsThere) {
  MediumPool pool(8);
  const std::vector<int> priority = {0, 0};
  const MediumId both = pool.enter(pool.enter(kVacuum, 0), 1);
  EXPECT_EQ(pool.current(both, priority), 1u);
  EXPECT_EQ(pool.current(pool.leave(both, 1), priority), 0u);
  EXPECT_EQ(pool.current(pool.leave(both, 0), priority), 1u);
}

TEST(MediumPool, HigherPriorityWinsWhateverTheOrder) {
  MediumPool pool(8);
  const std::vector<int> priority = {5, 1};
  EXPECT_EQ(pool.current(pool.enter(pool.enter(kVacuum, 0), 1), priority), 0u);
  EXPECT_EQ(pool.current(pool.enter(pool.enter(kVacuum, 1), 0), priority), 0u);
}

TEST(MediumPool, SameSituationHasSameId) {
  MediumPool pool(8);
  const MediumId a = pool.enter(pool.enter(kVacuum, 0), 1);
  const MediumId b = pool.enter(pool.enter(kVacuum, 0), 1);
  EXPECT_EQ(a, b);
  // Leaving the lower one and entering it again below what is above gives a list without it.
  EXPECT_EQ(pool.leave(a, 0), pool.enter(kVacuum, 1));
  EXPECT_EQ(pool.leave(pool.leave(a, 0), 1), kVacuum);
}

TEST(MediumPool, OneMaterialEnteredTwiceIsLeftTwice) {
  MediumPool pool(8);
  const MediumId twice = pool.enter(pool.enter(kVacuum, 7), 7);
  const MediumId once = pool.leave(twice, 7);
  EXPECT_TRUE(pool.contains(once, 7));
  EXPECT_EQ(pool.leave(once, 7), kVacuum);
}

}  // namespace
}  // namespace alhazen::render
