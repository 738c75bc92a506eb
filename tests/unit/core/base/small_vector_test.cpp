// A short list against std::vector, below, at and beyond the length that needs no allocation.
#include "core/base/small_vector.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

namespace alhazen {
namespace {

TEST(SmallVector, HoldsWhatWasPutIn) {
  for (std::size_t count = 0; count < 12; ++count) {
    SmallVector<std::string, 4> list;
    for (std::size_t i = 0; i < count; ++i)
      list.push_back(std::to_string(i));
    ASSERT_EQ(list.size(), count);
    EXPECT_EQ(list.empty(), count == 0);
    std::size_t i = 0;
    for (const std::string& element : list)
      EXPECT_EQ(element, std::to_string(i++)) << count;
    EXPECT_EQ(i, count);
  }
}

TEST(SmallVector, ShrinksAndGrowsAcrossItsLimit) {
  SmallVector<int, 3> list(5);
  EXPECT_EQ(list.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    list[i] = static_cast<int>(i);
  for (int round = 0; round < 3; ++round) {
    list.pop_back();
    list.pop_back();
    list.pop_back();
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[1], 1);
    for (int i = 2; i < 5; ++i)
      list.push_back(i);
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_EQ(list[i], static_cast<int>(i)) << round;
  }
}

// Each element is made once and destroyed once, wherever it lived.
TEST(SmallVector, KeepsNothingAlive) {
  const auto watched = std::make_shared<int>(0);
  for (std::size_t count = 0; count < 8; ++count) {
    {
      SmallVector<std::shared_ptr<int>, 3> list;
      for (std::size_t i = 0; i < count; ++i)
        list.push_back(watched);
      const SmallVector<std::shared_ptr<int>, 3> moved(std::move(list));
      EXPECT_EQ(moved.size(), count);
      EXPECT_EQ(watched.use_count(), 1 + static_cast<long>(count));
    }
    EXPECT_EQ(watched.use_count(), 1) << count;
  }
}

}  // namespace
}  // namespace alhazen
