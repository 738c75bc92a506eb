// A vector of chunks against std::vector.
#include "core/base/chunked_vector.h"

#include <gtest/gtest.h>
#include <string>

namespace alhazen {
namespace {

TEST(ChunkedVector, HoldsWhatWasPutIn) {
  ChunkedVector<std::string> strings;
  std::vector<std::string> expected;
  EXPECT_TRUE(strings.empty());
  for (int i = 0; i < 20000; ++i) {  // beyond the chunks that double
    strings.push_back(std::to_string(i));
    expected.push_back(std::to_string(i));
    ASSERT_EQ(strings.size(), expected.size());
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_EQ(strings[i], expected[i]) << i;
}

TEST(ChunkedVector, ElementsDoNotMove) {
  ChunkedVector<int> numbers;
  numbers.push_back(7);
  const int* const first = &numbers[0];
  for (int i = 1; i < 10000; ++i)
    numbers.push_back(i);
  EXPECT_EQ(&numbers[0], first);
}

TEST(ChunkedVector, ACopyIsItsOwn) {
  ChunkedVector<int> numbers;
  for (int i = 0; i < 100; ++i)
    numbers.push_back(i);
  ChunkedVector<int> copy = numbers;
  copy.push_back(100);
  EXPECT_EQ(numbers.size(), 100U);
  EXPECT_EQ(copy.size(), 101U);
  EXPECT_EQ(copy[99], 99);
  EXPECT_EQ(copy[100], 100);
}

}  // namespace
}  // namespace alhazen
