// Each lane does what a single number does: every operation, every width, against the same
// operation on numbers one by one.
#include "render/simd/lanes.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/math/random.h"
#include "core/math/vec.h"

namespace alhazen::render {
namespace {

// Numbers that find wrong comparisons and wrong zeros, then any bits at all.
template <class T>
std::vector<T> numbers() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> result;
  if constexpr (std::is_integral_v<T>) {
    result = {0, 1, 2, 3, static_cast<T>(-1), Limits::min(), Limits::max()};
  } else {
    result = {0,
              -T(0),
              1,
              -1,
              T(0.5),
              T(1.5),
              T(-2.5),
              T(3),
              Limits::infinity(),
              -Limits::infinity(),
              Limits::quiet_NaN(),
              Limits::denorm_min(),
              Limits::min(),
              Limits::max(),
              Limits::lowest(),
              1 + Limits::epsilon(),
              T(0x1p24),
              T(-0x1p23)};
  }
  for (std::uint64_t i = 0; result.size() < 96; ++i) {
    const std::uint64_t bits = mix_64(17, i);
    if constexpr (sizeof(T) == 8) {
      result.push_back(std::bit_cast<T>(bits));
    } else {
      result.push_back(std::bit_cast<T>(static_cast<std::uint32_t>(bits)));
    }
  }
  return result;
}

// The same bits; any NaN is as good as another.
template <class T>
bool same(T a, T b) {
  if constexpr (!std::is_integral_v<T>) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b && std::signbit(a) == std::signbit(b);
  } else {
    return a == b;
  }
}

template <class L>
class OfLanes : public testing::Test {
 protected:
  using T = typename L::Scalar;
  static constexpr int kWidth = L::kWidth;

  // Calls visit(lanes a, lanes b, numbers a, numbers b) over all pairs of numbers.
  template <class Visitor>
  static void pairs(const Visitor& visit) {
    const std::vector<T> all = numbers<T>();
    for (std::size_t shift = 0; shift < all.size(); ++shift) {
      for (std::size_t start = 0; start + kWidth <= all.size(); start += kWidth) {
        std::vector<T> a, b;
        for (std::size_t i = start; i < start + kWidth; ++i) {
          a.push_back(all[i]);
          b.push_back(all[(i + shift) % all.size()]);
        }
        visit(L::load(a.data()), L::load(b.data()), a, b);
      }
    }
  }
  static void expect(const L& lanes, const std::vector<T>& one, const char* what) {
    for (int i = 0; i < kWidth; ++i)
      ASSERT_TRUE(same(lanes[i], one[static_cast<std::size_t>(i)])) << what << ", lane " << i;
  }
  static void expect(typename L::Mask lanes, const std::vector<bool>& one, const char* what) {
    for (int i = 0; i < kWidth; ++i)
      ASSERT_EQ(lanes[i], one[static_cast<std::size_t>(i)]) << what << ", lane " << i;
  }
  template <class Function>
  static auto each(const std::vector<T>& a, const std::vector<T>& b, const Function& f) {
    std::vector<std::decay_t<decltype(f(a[0], b[0]))>> result;
    for (std::size_t i = 0; i < a.size(); ++i)
      result.push_back(f(a[i], b[i]));
    return result;
  }
};

using Every =
    testing::Types<Lanes<float, 1>, Lanes<float, 4>, Lanes<float, 8>, Lanes<float, 16>,
                   Lanes<double, 1>, Lanes<double, 2>, Lanes<double, 4>, Lanes<double, 8>>;
TYPED_TEST_SUITE(OfLanes, Every);

#define ALHAZEN_EXPECT_SAME(expression)                                                         \
  this->pairs([&](const TypeParam& la, const TypeParam& lb, const auto& va, const auto& vb) {   \
    const auto lanes = []([[maybe_unused]] const auto& a, [[maybe_unused]] const auto& b) {     \
      return expression;                                                                        \
    }(la, lb);                                                                                  \
    const auto one =                                                                            \
        this->each(va, vb, []([[maybe_unused]] const auto& a, [[maybe_unused]] const auto& b) { \
          return expression;                                                                    \
        });                                                                                     \
    this->expect(lanes, one, #expression);                                                      \
  })

TYPED_TEST(OfLanes, Arithmetic) {
  ALHAZEN_EXPECT_SAME(a + b);
  ALHAZEN_EXPECT_SAME(a - b);
  ALHAZEN_EXPECT_SAME(a * b);
  ALHAZEN_EXPECT_SAME(a / b);
  ALHAZEN_EXPECT_SAME(-a + 0 * b);
  ALHAZEN_EXPECT_SAME(2 * a);
}

TYPED_TEST(OfLanes, Comparisons) {
  ALHAZEN_EXPECT_SAME(a == b);
  ALHAZEN_EXPECT_SAME(a != b);
  ALHAZEN_EXPECT_SAME(a < b);
  ALHAZEN_EXPECT_SAME(a <= b);
  ALHAZEN_EXPECT_SAME(a > b);
  ALHAZEN_EXPECT_SAME(a >= b);
  ALHAZEN_EXPECT_SAME(a < b && a < 1);
  ALHAZEN_EXPECT_SAME(a < b || b < 1);
  ALHAZEN_EXPECT_SAME(!(a < b));
  ALHAZEN_EXPECT_SAME((a < b) == (b < 1));
  ALHAZEN_EXPECT_SAME((a < b) != (b < 1));
}

TYPED_TEST(OfLanes, Functions) {
  ALHAZEN_EXPECT_SAME(select(a < b, a, b));
  ALHAZEN_EXPECT_SAME(smaller(a, b));
  ALHAZEN_EXPECT_SAME(larger(a, b));
  ALHAZEN_EXPECT_SAME(fused_multiply_add(a, b, b));
  ALHAZEN_EXPECT_SAME(fused_multiply_add(a, b, -a));
  ALHAZEN_EXPECT_SAME(square_root(absolute(a)));
  ALHAZEN_EXPECT_SAME(square_root(a));
  ALHAZEN_EXPECT_SAME(round_down(a));
  ALHAZEN_EXPECT_SAME(is_finite(a));
  ALHAZEN_EXPECT_SAME(is_nan(a));
  ALHAZEN_EXPECT_SAME(difference_of_products(a, b, b, a));
}

TYPED_TEST(OfLanes, MemoryAndMasks) {
  using Number = typename TypeParam::Scalar;
  using Mask = typename TypeParam::Mask;
  constexpr int kLanes = TypeParam::kWidth;
  for (std::uint32_t pattern = 0; pattern < (1U << kLanes); pattern += kLanes == 16 ? 37 : 1) {
    const Mask mask = Mask::from_bits(pattern);
    EXPECT_EQ(mask.bits(), pattern);
    EXPECT_EQ(any(mask), pattern != 0);
    EXPECT_EQ(all(mask), pattern == (1U << kLanes) - 1);
    EXPECT_EQ(count(mask), std::popcount(pattern));
    std::vector<int> visited;
    for_each_lane(mask, [&](int i) { visited.push_back(i); });
    std::vector<Number> packed(kLanes + 1, Number(77));
    const int stored = TypeParam::iota().store_compressed(mask, packed.data());
    ASSERT_EQ(stored, static_cast<int>(visited.size()));
    for (int k = 0; k < stored; ++k)
      EXPECT_EQ(packed[k], static_cast<Number>(visited[k]));
    EXPECT_EQ(packed[kLanes], Number(77));
  }
  for (int n = 0; n <= kLanes; ++n)
    EXPECT_EQ(Mask::first(n).bits(), (1U << n) - 1);
  std::vector<Number> table(64);
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<Number>(3 * i);
  using Int = IntOf<TypeParam>;
  const Int index = (Int::iota() * 7) & 63;
  const TypeParam gathered = TypeParam::gather(table.data(), index);
  for (int i = 0; i < kLanes; ++i)
    EXPECT_EQ(gathered[i], static_cast<Number>(3 * ((7 * i) & 63)));
}

}  // namespace
}  // namespace alhazen::render
