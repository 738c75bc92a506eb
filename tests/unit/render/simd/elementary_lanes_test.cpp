// The elementary functions on lanes give the bits that they give to single numbers.
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/hash.h"
#include "render/simd/elementary.h"

namespace alhazen::render {
namespace {

// Arguments of six kinds: any bits, what angles and cosines are, what exponents are, all sizes, and
// the ends of every domain and range.
template <class T>
T argument(std::uint64_t i, std::uint64_t stream) {
  const std::uint64_t word = mix_64(mix_64(stream), i);
  const double unit = static_cast<double>(word >> 11) * 0x1p-53;
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr double kEdges[] = {
      0,           -0.0,        1,          -1,        0.5,       -0.5,  kInf,     -kInf,
      NAN,         0x1p-1074,   -0x1p-1074, 0x1p-1022, 1.7e308,   709.8, 709.79,   -746,
      -745.2,      -708.5,      0x1p64,     0x1p-64,   0x1.fp-65, 2,     0x1p-149, 0x1p-126,
      1 + 0x1p-52, 1 - 0x1p-53, 1e-310,     3e-320,    88.7,      -103.9};
  switch (mix_64(word) % 6) {
    case 0:
      if constexpr (sizeof(T) == 4) return std::bit_cast<T>(static_cast<std::uint32_t>(word));
      if constexpr (sizeof(T) == 8) return std::bit_cast<T>(word);
      return static_cast<T>(std::bit_cast<double>(word));
    case 1:
      return static_cast<T>(unit);
    case 2:
      return static_cast<T>(2 * unit - 1);
    case 3:
      return static_cast<T>(1500 * unit - 750);
    case 4:
      return static_cast<T>(std::ldexp(unit - 0.5, static_cast<int>(word % 140) - 70));
    default:
      return static_cast<T>(kEdges[(word >> 8) % std::size(kEdges)]);
  }
}

template <class T>
testing::AssertionResult same(T lane, T one) {
  const bool both_none = is_nan(lane) && is_nan(one);
  const bool equal =
      lane == one && ScalarTraits<T>::sign_bit(lane) == ScalarTraits<T>::sign_bit(one);
  if (both_none || equal) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << static_cast<double>(lane) << " instead of " << static_cast<double>(one);
}

template <class L>
class ElementaryOf : public testing::Test {
 protected:
  using T = typename L::Scalar;
  static constexpr std::uint64_t kPackets = sizeof(T) == 16 ? 300 : 60000 / L::kWidth;

  // `on_lanes` of lanes a and b is in each lane what `on_one` is of its numbers.
  template <class OnLanes, class OnOne>
  static void expect_same(const OnLanes& on_lanes, const OnOne& on_one) {
    for (std::uint64_t start = 0; start < kPackets; ++start) {
      L a, b;
      for (int i = 0; i < L::kWidth; ++i) {
        a.set(i, argument<T>(start * L::kWidth + static_cast<std::uint64_t>(i), 1));
        b.set(i, argument<T>(start * L::kWidth + static_cast<std::uint64_t>(i), 2));
      }
      const L lanes = on_lanes(a, b);
      for (int i = 0; i < L::kWidth; ++i) {
        ASSERT_TRUE(same(lanes[i], on_one(a[i], b[i])))
            << "of " << static_cast<double>(a[i]) << ", " << static_cast<double>(b[i]);
      }
    }
  }
};
#if ALHAZEN_HAS_QUAD
using Widest = Lanes<Quad, 1>;
#else
using Widest = Lanes<double, 4>;
#endif
using Every = testing::Types<Lanes<double, 1>, Lanes<double, 2>, Lanes<double, 8>, Lanes<float, 8>,
                             Lanes<float, 16>, Widest>;
TYPED_TEST_SUITE(ElementaryOf, Every);

TYPED_TEST(ElementaryOf, Exponential) {
  const auto f = [](auto a, auto) { return exp_of(a); };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, Logarithm) {
  const auto f = [](auto a, auto) { return log_of(a); };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, Power) {
  const auto f = [](auto a, auto b) { return power(a, b); };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, PowersOfPositiveNumbers) {
  const auto f = [](auto a, auto b) { return power(absolute(a), b); };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, Sine) {
  const auto f = [](auto a, auto) { return sin_cos_of_turns(a).sin; };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, Cosine) {
  const auto f = [](auto a, auto) { return sin_cos_of_turns(a).cos; };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, AngleOfAPoint) {
  const auto f = [](auto a, auto b) { return atan2_turns(a, b); };
  this->expect_same(f, f);
}
TYPED_TEST(ElementaryOf, ArcOfACosine) {
  const auto f = [](auto a, auto) { return acos_turns(a); };
  this->expect_same(f, f);
}

}  // namespace
}  // namespace alhazen::render
