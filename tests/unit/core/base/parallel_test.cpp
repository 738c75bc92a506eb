#include "core/base/parallel.h"

#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

namespace alhazen {
namespace {

TEST(Parallel, EachOnceForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    for (const std::size_t count : {0u, 1u, 5u, 1000u}) {
      std::vector<std::atomic<int>> calls(count);
      in_parallel(threads, count, [&](std::size_t i) { ++calls[i]; });
      for (const auto& n : calls)
        EXPECT_EQ(n, 1);
    }
  }
}

TEST(Parallel, AnExceptionReachesTheCallerOnce) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(in_parallel(threads, 100,
                             [](std::size_t i) {
                               if (i % 10 == 3) throw std::runtime_error("three");
                             }),
                 std::runtime_error);
  }
}

TEST(Parallel, AtLeastOneThread) {
  EXPECT_GE(thread_count(0), 1);
  EXPECT_EQ(thread_count(3), 3);
}

}  // namespace
}  // namespace alhazen
