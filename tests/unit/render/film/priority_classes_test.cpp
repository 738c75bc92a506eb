#include "render/film/priority_classes.h"

#include <gtest/gtest.h>

namespace alhazen::render {
namespace {

TEST(PriorityClasses, GoUpWithPriority) {
  EXPECT_EQ(PriorityClasses::of(0), 0);
  EXPECT_GT(PriorityClasses::of(1e-300), 0);
  int before = 0;
  for (double priority = 1e-20; priority < 1e10; priority *= 1.1) {
    const int k = PriorityClasses::of(priority);
    EXPECT_GT(k, before);
    before = k;
  }
}

// Random noise of variance V in equal pixels with one sample each: to halve the sum all are
// doubled.
TEST(PriorityClasses, EqualPixelsAreChosenTogether) {
  PriorityClasses classes;
  const int k = PriorityClasses::of(1);
  classes.add(k, 1, 1);
  classes.add(k, 1, 1);
  EXPECT_EQ(classes.threshold_of_squares(2, 1), k - 1);
  EXPECT_EQ(classes.samples_above(k - 1), 2);
  EXPECT_EQ(classes.samples_above(k), 0);
}

// The pixels that are worst are chosen until what the others cost is within the goal, and no class
// that would make them more than so many.
TEST(PriorityClasses, TheMostIsALimit) {
  PriorityClasses classes;
  const int low = PriorityClasses::of(1), high = PriorityClasses::of(100);
  for (int i = 0; i < 10; ++i)
    classes.add(low, 1, 1);
  classes.add(high, 100, 1);
  EXPECT_GE(classes.threshold_of_most(5, 0), low);
  EXPECT_LT(classes.threshold_of_most(5, 0), high);
  EXPECT_LT(classes.threshold_of_most(11, 0), low);
  EXPECT_GE(classes.threshold_of_most(5, 200), high);  // nothing is worth a look
}

}  // namespace
}  // namespace alhazen::render
