// core/math: exponential, logarithm and power in double, by way of double-word numbers.
#include <bit>
#include <cstdint>

#include "core/math/elementary.h"
#include "core/math/error_free.h"

namespace alhazen {
namespace {

using Word = DoubleWord<double>;

constexpr double kLog2E = 0x1.71547652b82fep+0;
// ln 2 in three parts; the first has 42 bits, so that its product with an exponent is exact.
constexpr double kLn2Head = 0x1.62e42fefa3800p-1;
constexpr Word kLn2Tail{0x1.ef35793c76730p-45, 0x1.f97b57a079a19p-103};

constexpr double power_of_two(int exponent) {  // -1022 <= exponent <= 1023
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// value * 2^exponent for |exponent| <= 1100, rounded once when value is normal.
double scaled_by_power_of_two(double value, int exponent) {
  if (exponent > 1023) return value * power_of_two(1023) * power_of_two(exponent - 1023);
  if (exponent < -1022) return value * power_of_two(exponent + 1022) * power_of_two(-1022);
  return value * power_of_two(exponent);
}

// e^x: x = k ln 2 + r with |r| <= ln(2)/2, and the Taylor series of e^r, whose first two terms are
// added without loss. Error < 0.53 ulp for exact x, before a subnormal result is rounded.
double exp_of_word(Word x) {
  if (x.hi > 709.8) return infinity<double>();
  if (x.hi < -746) return 0;
  const double k = round_down(fused_multiply_add(x.hi, kLog2E, 0.5));
  const Word r = two_sum(x.hi - k * kLn2Head, -k * kLn2Tail.hi) + x.lo;
  constexpr double kInverseFactorial[] = {
      1. / 2,         1. / 6,          1. / 24,         1. / 120,     1. / 720,
      1. / 5040,      1. / 40320,      1. / 362880,     1. / 3628800, 1. / 39916800,
      1. / 479001600, 1. / 6227020800, 1. / 87178291200};
  double series = kInverseFactorial[12];
  for (int i = 11; i >= 0; --i)
    series = fused_multiply_add(series, r.hi, kInverseFactorial[i]);
  const Word head = two_sum(1.0, r.hi);
  // d(r^2/2) for the low word of r is r.hi * r.lo.
  const double tail = fused_multiply_add(r.hi * r.hi, series, fused_multiply_add(r.hi, r.lo, r.lo));
  return scaled_by_power_of_two(head.hi + (head.lo + tail), static_cast<int>(k));
}

// ln x for finite x > 0, relative error < 2^-64: x = 2^k m with m in [sqrt(1/2), sqrt 2), and
// ln m = 2 artanh s = 2 s (1 + z/3 + z^2/5 + ...), s = (m - 1)/(m + 1), z = s^2 < 0.0295.
// The first two quotients are taken in two words, the rest is below 2^-12 of the whole.
Word log_word(double x) {
  int k = 0;
  if (x < power_of_two(-1022)) {
    x *= power_of_two(54);
    k = -54;
  }
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  k += static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m > 0x1.6a09e667f3bcdp+0) {
    m *= 0.5;
    ++k;
  }
  const Word s = Word{m - 1, 0} / two_sum(m, 1.0);
  const Word z = s * s;
  double series = 1. / 27;
  for (int odd = 25; odd >= 7; odd -= 2)
    series = fused_multiply_add(series, z.hi, 1. / odd);
  constexpr Word kThird{0x1.5555555555555p-2, 0x1.5555555555555p-56};
  constexpr Word kFifth{0x1.999999999999ap-3, -0x1.999999999999ap-57};
  const Word sum = (z * (kThird + z * (kFifth + z * series))) + 1.0;
  const Word log_m = s * sum * 2.0;
  if (k == 0) return log_m;
  const double count = k;
  return (kLn2Tail * count + log_m) + count * kLn2Head;
}

}  // namespace

double exp_of(double x) {
  if (is_nan(x)) return x;
  return exp_of_word({x, 0});
}

double log_of(double x) {
  if (is_nan(x) || x == infinity<double>()) return x;
  if (x == 0) return -infinity<double>();
  if (x < 0) return std::numeric_limits<double>::quiet_NaN();
  return log_word(x).hi;
}

double power(double base, double exponent) {
  if (exponent == 0 || base == 1) return 1;
  if (is_nan(base) || is_nan(exponent) || base < 0) return std::numeric_limits<double>::quiet_NaN();
  if (base == 0) return exponent > 0 ? 0 : infinity<double>();
  if (base == infinity<double>()) return exponent > 0 ? infinity<double>() : 0;
  if (!is_finite(exponent)) return (base > 1) == (exponent > 0) ? infinity<double>() : 0;
  const Word log_base = log_word(base);
  const double size = log_base.hi * exponent;
  // Far outside of the range the low word would be inf - inf.
  if (absolute(size) > 1000) return exp_of(size);
  return exp_of_word(log_base * exponent);
}

float exp_of(float x) {
  return static_cast<float>(exp_of(static_cast<double>(x)));
}
float log_of(float x) {
  return static_cast<float>(log_of(static_cast<double>(x)));
}
float power(float base, float exponent) {
  return static_cast<float>(power(static_cast<double>(base), static_cast<double>(exponent)));
}

}  // namespace alhazen
