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

// Lanes rely on it where nothing is nested.
TEST(MediumPool, ListOfOneMaterialHasItsNumber) {
  MediumPool pool(3);
  for (const MaterialId material : {0u, 1u, 2u}) {
    EXPECT_EQ(pool.enter(kVacuum, material), static_cast<MediumId>(material));
    EXPECT_TRUE(pool.is_single(pool.enter(kVacuum, material)));
    EXPECT_EQ(pool.current(static_cast<MediumId>(material), {0, 0, 0}), material);
  }
  EXPECT_TRUE(pool.is_single(kVacuum));
  EXPECT_FALSE(pool.is_single(pool.enter(1, 2)));
  EXPECT_FALSE(pool.is_single(pool.enter(1, 1)));
}

// Thousands of lists are dropped, few are kept; either way they are found again.
TEST(MediumPool, ForgetsWhatHasBecomeMuch) {
  MediumPool pool(100);
  for (int round = 0; round < 3; ++round) {
    for (MaterialId a = 0; a < 100; ++a) {
      for (MaterialId b = 0; b < 100; ++b) {
        const MediumId both = pool.enter(pool.enter(kVacuum, a), b);
        ASSERT_EQ(pool.leave(both, b), static_cast<MediumId>(a));
        ASSERT_TRUE(pool.contains(both, a));
      }
    }
    pool.forget_much();
  }
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
