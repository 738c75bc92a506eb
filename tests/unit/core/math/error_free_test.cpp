#include "core/math/error_free.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

#include "core/base/hash.h"

namespace alhazen {
namespace {

double any_size(std::uint64_t i) {
  const double significand = static_cast<double>(mix_64(i) >> 11) * 0x1p-52 - 1;
  return std::ldexp(significand, static_cast<int>(mix_64(i, 1) % 100) - 50);
}

#if ALHAZEN_HAS_QUAD
Quad value(DoubleWord<double> a) {
  return static_cast<Quad>(a.hi) + static_cast<Quad>(a.lo);
}

TEST(ErrorFree, SumsAndProductsAreExact) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double a = any_size(2 * i), b = any_size(2 * i + 1);
    // The product has at most 106 bits, a Quad 113; the sum may have more, so its words are
    // checked by taking them away one at a time, which is exact.
    EXPECT_TRUE(value(two_product(a, b)) == static_cast<Quad>(a) * static_cast<Quad>(b));
    const auto sum = two_sum(a, b);
    const double large = std::fabs(a) < std::fabs(b) ? b : a;
    const double small = std::fabs(a) < std::fabs(b) ? a : b;
    EXPECT_TRUE((static_cast<Quad>(sum.hi) - static_cast<Quad>(large)) ==
                static_cast<Quad>(small) - static_cast<Quad>(sum.lo));
    EXPECT_EQ(quick_two_sum(large, small).lo, sum.lo);
  }
}

TEST(ErrorFree, TwoWordOperationsKeepTheirBounds) {
  const double u2 = 0x1p-106;
  const auto within = [](DoubleWord<double> got, Quad truth, double bound) {
    // 2^-112: the truth is itself rounded, a few times.
    return absolute(value(got) - truth) <= static_cast<Quad>(bound + 0x1p-110) * absolute(truth);
  };
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const DoubleWord<double> a = two_product(any_size(4 * i), any_size(4 * i + 1));
    const DoubleWord<double> b = two_product(any_size(4 * i + 2), any_size(4 * i + 3));
    EXPECT_TRUE(within(a + b, value(a) + value(b), 3.1 * u2));
    EXPECT_TRUE(within(a * b, value(a) * value(b), 5 * u2));
    EXPECT_TRUE(within(a / b, value(a) / value(b), 15 * u2));
    EXPECT_TRUE(within(a * b.hi, value(a) * static_cast<Quad>(b.hi), 2 * u2));
    EXPECT_TRUE(within(a + b.hi, value(a) + static_cast<Quad>(b.hi), 2 * u2));
    const DoubleWord<double> square = a * a;
    // One Newton step squares the relative error u of the rounded root.
    EXPECT_TRUE(within(square_root(square), square_root(value(square)), 8 * u2));
  }
}
#endif

TEST(ErrorFree, DifferenceOfProductsKeepsWhatCancels) {
  // (1 + 2^-30)^2 - (1 + 2^-29) * 1 = 2^-60, all of which a plain evaluation loses.
  const double a = 1 + 0x1p-30;
  EXPECT_EQ(difference_of_products(a, a, 1 + 0x1p-29, 1.0), 0x1p-60);
}

}  // namespace
}  // namespace alhazen
