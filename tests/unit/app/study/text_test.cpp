#include <gtest/gtest.h>

#include "app/study/number_text.h"
#include "app/study/timing.h"

namespace alhazen {
namespace {

TEST(NumberText, ThreeDigitsOrAnExponent) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(0.0123456), "0.0123");
  EXPECT_EQ(number_text(0.00392157), "0.00392");
  EXPECT_EQ(number_text(1), "1");
  EXPECT_EQ(number_text(999.4), "999");
  EXPECT_EQ(number_text(12345), "12345");
  EXPECT_EQ(number_text(0.000123), "1.2e-04");
  EXPECT_EQ(number_text(3.7e9), "3.7e+09");
}

TEST(NumberText, PrintHasRaisedExponents) {
  EXPECT_EQ(print_number(0.0123456), "0.0123");
  EXPECT_EQ(print_number(1.2e-16), "1.2\u00a0\u00d7\u00a010\u207b\u00b9\u2076");
  EXPECT_EQ(print_number(3.7e9), "3.7\u00a0\u00d7\u00a010\u2079");
}

TEST(NumberText, TimesHaveTheUnitThatSuits) {
  EXPECT_EQ(duration_text(0.00045), "0.45 ms");
  EXPECT_EQ(duration_text(0.0123), "12.3 ms");
  EXPECT_EQ(duration_text(0.9999), "1 s");
  EXPECT_EQ(duration_text(1.234), "1.23 s");
  EXPECT_EQ(duration_text(59.99), "1 min 00 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(3725), "1 h 02 min");
}

TEST(NumberText, SharesAndRatios) {
  EXPECT_EQ(percent_text(0), "0 %");
  EXPECT_EQ(percent_text(0.1234), "12.3 %");
  EXPECT_EQ(percent_text(0.0123), "1.2 %");
  EXPECT_EQ(percent_text(1e-6), "under 0.01 %");
  EXPECT_EQ(ratio_text(14.4), "14");
  EXPECT_EQ(ratio_text(2.345), "2.3");
}

TEST(Timing, MedianIsTheMiddleOfSortedTimes) {
  const Spread odd = spread_of({3, 1, 2});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(odd.low, 1);
  EXPECT_EQ(odd.high, 3);
  EXPECT_EQ(spread_of({4, 1, 2, 3}).median, 2.5);
  EXPECT_EQ(spread_of({7}).median, 7);
}

}  // namespace
}  // namespace alhazen
