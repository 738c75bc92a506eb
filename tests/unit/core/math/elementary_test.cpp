#include "core/math/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "core/math/random.h"

namespace alhazen {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

// Distance between neighbours at x, as the C library's ilogb would give it.
double ulp_of(double x) {
  return std::ldexp(1.0, x == 0 ? -1074 : std::max(std::ilogb(x) - 52, -1074));
}

double evaluate(const std::string& name, const std::vector<double>& a) {
  if (name == "exp_of") return exp_of(a[0]);
  if (name == "log_of") return log_of(a[0]);
  if (name == "power") return power(a[0], a[1]);
  if (name == "sin_deg") return sin_deg(a[0]);
  if (name == "cos_deg") return cos_deg(a[0]);
  if (name == "tan_deg") return tan_deg(a[0]);
  if (name == "sin_turns") return sin_cos_of_turns(a[0]).sin;
  if (name == "cos_turns") return sin_cos_of_turns(a[0]).cos;
  if (name == "asin_deg") return asin_deg(a[0]);
  if (name == "acos_deg") return acos_deg(a[0]);
  if (name == "acos_turns") return acos_turns(a[0]);
  if (name == "atan2_deg") return atan2_deg(a[0], a[1]);
  if (name == "atan2_turns") return atan2_turns(a[0], a[1]);
  ADD_FAILURE() << "no function " << name;
  return kNaN;
}

// The contract: 1 ulp of the truth, which the table gives in two words.
TEST(Elementary, WithinOneUlpOfGoldenTable) {
  std::ifstream table(ALHAZEN_SOURCE_DIR "/tests/golden/elementary/table.txt");
  std::string line;
  int lines = 0;
  double worst = 0;
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::string name, word;
    words >> name;
    std::vector<double> numbers;
    while (words >> word)
      numbers.push_back(std::strtod(word.c_str(), nullptr));
    ASSERT_GE(numbers.size(), 3u) << line;
    const double low = numbers.back();
    numbers.pop_back();
    const double high = numbers.back();
    numbers.pop_back();
    const double error = std::fabs((evaluate(name, numbers) - high) - low) / ulp_of(high);
    EXPECT_LE(error, 1) << line;
    worst = std::max(worst, error);
    ++lines;
  }
  EXPECT_GT(lines, 1000);
  RecordProperty("worst_ulp", std::to_string(worst));
}

#if ALHAZEN_HAS_QUAD
// The same contract on many more arguments, with libquadmath's 113 bits as the truth.
double error_in_ulps(double got, Quad truth) {
  const Quad error = absolute(static_cast<Quad>(got) - truth);
  return static_cast<double>(error / static_cast<Quad>(ulp_of(static_cast<double>(truth))));
}

double uniform(std::uint64_t i, double from, double to) {
  return from + (to - from) * (static_cast<double>(mix_64(i) >> 11) * 0x1p-53);
}

TEST(Elementary, WithinOneUlpOfQuadOverSweeps) {
  double worst[6] = {};
  const auto note = [&worst](int which, double got, Quad truth) {
    worst[which] = std::max(worst[which], error_in_ulps(got, truth));
  };
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double x = uniform(i, -740, 700), u = uniform(i + 1000000, -3, 3);
    const double size = std::ldexp(uniform(i, 1, 2), static_cast<int>(i % 2000) - 1000);
    note(0, exp_of(x), exp_of(static_cast<Quad>(x)));
    note(1, log_of(size), log_of(static_cast<Quad>(size)));
    note(1, log_of(absolute(u)), log_of(static_cast<Quad>(absolute(u))));
    const double exponent = x / log_of(size);
    note(2, power(size, exponent), power(static_cast<Quad>(size), static_cast<Quad>(exponent)));
    const SinCos<Quad> truth = sin_cos_of_turns(static_cast<Quad>(u));
    note(3, sin_cos_of_turns(u).sin, truth.sin);
    note(3, sin_cos_of_turns(u).cos, truth.cos);
    const double v = uniform(i + 2000000, -3, 3);
    note(4, atan2_turns(u, v), atan2_turns(static_cast<Quad>(u), static_cast<Quad>(v)));
    note(5, acos_turns(u / 3), acos_turns(static_cast<Quad>(u / 3)));
  }
  for (int which = 0; which < 6; ++which)
    EXPECT_LE(worst[which], 1) << "function " << which;
}
#endif

TEST(Elementary, DegreesAreExactWhereTheResultIs) {
  const double sines[] = {0, 0.5, kNaN, 1, kNaN, 0.5, 0, -0.5, kNaN, -1, kNaN, -0.5};
  for (int i = -60; i <= 60; ++i) {
    const double expected = sines[((i % 12) + 12) % 12];
    if (std::isnan(expected)) continue;
    EXPECT_EQ(sin_deg(30.0 * i), expected) << 30 * i;
    EXPECT_EQ(cos_deg(30.0 * i - 90), expected) << 30 * i - 90;
  }
  EXPECT_EQ(tan_deg(45), 1);
  EXPECT_EQ(tan_deg(135), -1);
  EXPECT_EQ(tan_deg(180), 0);
  EXPECT_EQ(tan_deg(90), kInf);
  EXPECT_EQ(tan_deg(-90), -kInf);
  EXPECT_EQ(asin_deg(0.5), 30);
  EXPECT_EQ(asin_deg(-1), -90);
  EXPECT_EQ(acos_deg(0.5), 60);
  EXPECT_EQ(acos_deg(-0.5), 120);
  EXPECT_EQ(acos_deg(-1), 180);
  EXPECT_EQ(acos_deg(1), 0);
  EXPECT_EQ(acos_deg(0), 90);
  for (int i = 0; i <= 7; ++i) {
    const double y[] = {0, 1, 1, 1, 0, -1, -1, -1}, x[] = {1, 1, 0, -1, -1, -1, 0, 1};
    const double angle = i <= 4 ? 45.0 * i : 45.0 * i - 360;
    EXPECT_EQ(atan2_deg(y[i], x[i]), angle);
    EXPECT_EQ(atan2_turns(y[i], x[i]), angle / 360);
    EXPECT_EQ(atan2_turns(y[i] * 0x1p900, x[i] * 0x1p900), angle / 360);
  }
}

TEST(Elementary, SymmetricInBits) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const double x =
        std::ldexp(static_cast<double>(mix_64(i) >> 11), static_cast<int>(i % 120) - 90);
    EXPECT_EQ(bits_of(sin_deg(-x)), bits_of(-sin_deg(x)));
    EXPECT_EQ(bits_of(cos_deg(-x)), bits_of(cos_deg(x)));
    EXPECT_EQ(bits_of(tan_deg(-x)), bits_of(-tan_deg(x)));
    const SinCos<double> plus = sin_cos_of_turns(x), minus = sin_cos_of_turns(-x);
    EXPECT_EQ(bits_of(minus.sin), bits_of(-plus.sin));
    EXPECT_EQ(bits_of(minus.cos), bits_of(plus.cos));
    EXPECT_EQ(bits_of(atan2_turns(-x, 3.0)), bits_of(-atan2_turns(x, 3.0)));
  }
}

TEST(Elementary, PowerAtItsFixedPoints) {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    double x = std::fabs(std::bit_cast<double>(mix_64(i)));
    if (!std::isfinite(x)) continue;
    EXPECT_EQ(power(x, 1.0), x);
    EXPECT_EQ(power(x, 0.0), 1);
    EXPECT_EQ(power(1.0, x), 1);
  }
  EXPECT_EQ(power(0.0, 0.0), 1);
  EXPECT_EQ(power(0.0, 2.0), 0);
  EXPECT_EQ(power(0.0, -2.0), kInf);
  EXPECT_EQ(power(2.0, 10.0), 1024);
  EXPECT_EQ(power(2.0, -1074.0), 0x1p-1074);
  EXPECT_EQ(power(2.0, 1023.0), 0x1p1023);
  EXPECT_EQ(power(10.0, 15.0), 1e15);
  EXPECT_EQ(power(0.5, kInf), 0);
  EXPECT_EQ(power(2.0, -kInf), 0);
  EXPECT_EQ(power(kInf, 2.0), kInf);
  EXPECT_EQ(power(1e200, 1e300), kInf);
  EXPECT_EQ(power(1e-200, 1e300), 0);
  EXPECT_TRUE(std::isnan(power(-1.0, 2.0)));
  EXPECT_TRUE(std::isnan(power(kNaN, 2.0)));
}

TEST(Elementary, EdgesOfTheDomains) {
  EXPECT_EQ(exp_of(0.0), 1);
  EXPECT_EQ(exp_of(710.0), kInf);
  EXPECT_EQ(exp_of(kInf), kInf);
  EXPECT_EQ(exp_of(-kInf), 0);
  EXPECT_EQ(exp_of(-746.0), 0);
  EXPECT_EQ(exp_of(-745.0), 0x1p-1074);
  EXPECT_TRUE(std::isnan(exp_of(kNaN)));
  EXPECT_EQ(log_of(1.0), 0);
  EXPECT_EQ(log_of(0.0), -kInf);
  EXPECT_EQ(log_of(kInf), kInf);
  EXPECT_TRUE(std::isnan(log_of(-1.0)));
  EXPECT_TRUE(std::isnan(sin_deg(kInf)));
  EXPECT_TRUE(std::isnan(cos_deg(kNaN)));
  EXPECT_TRUE(std::isnan(sin_cos_of_turns(kInf).sin));
  EXPECT_TRUE(std::isnan(acos_turns(1.5)));
  EXPECT_TRUE(std::isnan(asin_deg(-2)));
  EXPECT_TRUE(std::isnan(atan2_turns(kNaN, 1.0)));
  EXPECT_EQ(bits_of(sin_deg(-0.0)), bits_of(-0.0));
  EXPECT_EQ(bits_of(sin_cos_of_turns(-0.0).sin), bits_of(-0.0));
  EXPECT_EQ(bits_of(asin_deg(-0.0)), bits_of(-0.0));
  EXPECT_EQ(atan2_turns(-0.0, -1.0), -0.5);
  EXPECT_EQ(atan2_turns(kInf, -kInf), 0.375);
  EXPECT_EQ(atan2_turns(1.0, kInf), 0);
  EXPECT_EQ(atan2_turns(0x1p-1074, 0x1p-1074), 0.125);
  EXPECT_EQ(atan2_deg(-0.0, -1), 180);
}

TEST(Elementary, FloatIsTheRoundedDouble) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const float x = static_cast<float>(mix_64(i) >> 40) * 0x1p-20f;
    EXPECT_EQ(exp_of(x), static_cast<float>(exp_of(static_cast<double>(x))));
    EXPECT_EQ(log_of(x), static_cast<float>(log_of(static_cast<double>(x))));
    EXPECT_EQ(sin_cos_of_turns(x).cos, static_cast<float>(sin_cos_of_turns(double{x}).cos));
    EXPECT_EQ(atan2_turns(x, -1.0f), static_cast<float>(atan2_turns(double{x}, -1.0)));
  }
}

}  // namespace
}  // namespace alhazen
