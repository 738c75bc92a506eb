// Lanes of whole numbers, and what leads from one kind of lanes to another: against the same on
// numbers one by one.
#include <bit>
#include <gtest/gtest.h>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/base/hash.h"
#include "render/simd/lanes.h"

namespace alhazen::render {
namespace {

template <class T>
T any_bits(std::uint64_t i) {
  const std::uint64_t bits = mix_64(23, i);
  if constexpr (sizeof(T) == 8)
    return std::bit_cast<T>(bits);
  else
    return std::bit_cast<T>(static_cast<std::uint32_t>(bits));
}

// Ends of the range, what is next to them, and any bits.
template <class T>
T whole(std::uint64_t i) {
  using Limits = std::numeric_limits<T>;
  const T ends[] = {0,
                    1,
                    2,
                    static_cast<T>(-1),
                    Limits::min(),
                    Limits::max(),
                    static_cast<T>(Limits::max() - 1),
                    static_cast<T>(T{1} << (sizeof(T) * 4))};
  return i % 3 == 0 ? ends[i / 3 % 8] : any_bits<T>(i);
}

template <class L>
class OfWholeLanes : public testing::Test {
 protected:
  using T = typename L::Scalar;
  static constexpr int kWidth = L::kWidth;

  static L some(std::uint64_t start, std::uint64_t step) {
    L result;
    for (int i = 0; i < kWidth; ++i)
      result.set(i, whole<T>(start + step * static_cast<std::uint64_t>(i)));
    return result;
  }
  template <class Visitor>
  static void pairs(const Visitor& visit) {
    for (std::uint64_t i = 0; i < 400; ++i)
      visit(some(i, 1), some(7 * i, 3));
  }
};
using Wholes =
    testing::Types<Lanes<std::int32_t, 1>, Lanes<std::int32_t, 4>, Lanes<std::int32_t, 16>,
                   Lanes<std::uint32_t, 8>, Lanes<std::uint32_t, 16>, Lanes<std::int64_t, 2>,
                   Lanes<std::int64_t, 8>, Lanes<std::uint64_t, 4>, Lanes<std::uint64_t, 16>>;
TYPED_TEST_SUITE(OfWholeLanes, Wholes);

TYPED_TEST(OfWholeLanes, ArithmeticIsModuloTwoToTheBits) {
  using Number = typename TypeParam::Scalar;
  if constexpr (std::is_unsigned_v<Number>) {
    this->pairs([](const TypeParam& a, const TypeParam& b) {
      const TypeParam sum = a + b, difference = a - b, product = a * b;
      for (int i = 0; i < TypeParam::kWidth; ++i) {
        ASSERT_EQ(sum[i], static_cast<Number>(a[i] + b[i]));
        ASSERT_EQ(difference[i], static_cast<Number>(a[i] - b[i]));
        ASSERT_EQ(product[i], static_cast<Number>(a[i] * b[i]));
      }
    });
  } else {  // a sum beyond the range has no meaning here, so halves are taken
    this->pairs([](const TypeParam& whole_a, const TypeParam& whole_b) {
      const TypeParam a = whole_a >> (sizeof(Number) * 4), b = whole_b >> (sizeof(Number) * 4 + 1);
      const TypeParam sum = a + b, difference = a - b, product = a * b, opposite = -a;
      for (int i = 0; i < TypeParam::kWidth; ++i) {
        ASSERT_EQ(sum[i], a[i] + b[i]);
        ASSERT_EQ(difference[i], a[i] - b[i]);
        ASSERT_EQ(product[i], a[i] * b[i]);
        ASSERT_EQ(opposite[i], -a[i]);
      }
    });
  }
}

TYPED_TEST(OfWholeLanes, Bits) {
  using Number = typename TypeParam::Scalar;
  this->pairs([](const TypeParam& a, const TypeParam& b) {
    const TypeParam both = a & b, either = a | b, differing = a ^ b;
    for (int i = 0; i < TypeParam::kWidth; ++i) {
      ASSERT_EQ(both[i], a[i] & b[i]);
      ASSERT_EQ(either[i], a[i] | b[i]);
      ASSERT_EQ(differing[i], a[i] ^ b[i]);
    }
    for (int by = 0; by < static_cast<int>(8 * sizeof(Number)); ++by) {
      const TypeParam up = a << by, down = a >> by;
      for (int i = 0; i < TypeParam::kWidth; ++i) {
        ASSERT_EQ(up[i], static_cast<Number>(a[i] << by));
        ASSERT_EQ(down[i], static_cast<Number>(a[i] >> by)) << a[i] << " >> " << by;
      }
    }
  });
}

TYPED_TEST(OfWholeLanes, ComparisonsAndChoices) {
  this->pairs([](const TypeParam& a, const TypeParam& b) {
    const auto equal = a == b, unequal = a != b, less = a<b, less_equal = a <= b, more = a> b,
               more_equal = a >= b;
    const TypeParam least = select(less, a, b), least_again = smaller(a, b);
    for (int i = 0; i < TypeParam::kWidth; ++i) {
      ASSERT_EQ(equal[i], a[i] == b[i]);
      ASSERT_EQ(unequal[i], a[i] != b[i]);
      ASSERT_EQ(less[i], a[i] < b[i]) << a[i] << " < " << b[i];
      ASSERT_EQ(less_equal[i], a[i] <= b[i]);
      ASSERT_EQ(more[i], a[i] > b[i]);
      ASSERT_EQ(more_equal[i], a[i] >= b[i]);
      ASSERT_EQ(least[i], a[i] < b[i] ? a[i] : b[i]);
      ASSERT_EQ(least_again[i], least[i]);
    }
  });
}

TYPED_TEST(OfWholeLanes, StoreCompressedKeepsOrderAndBounds) {
  using Number = typename TypeParam::Scalar;
  constexpr int kLanes = TypeParam::kWidth;
  const TypeParam values = this->some(1, 2);
  for (std::uint32_t pattern = 0; pattern < (1U << kLanes); pattern += kLanes == 16 ? 37 : 1) {
    const auto mask = TypeParam::Mask::from_bits(pattern);
    std::vector<Number> packed(kLanes + 1, Number{77}), wanted;
    for_each_lane(mask, [&](int i) { wanted.push_back(values[i]); });
    const auto stored = static_cast<std::size_t>(values.store_compressed(mask, packed.data()));
    ASSERT_EQ(stored, wanted.size());
    EXPECT_EQ(packed.back(), Number{77});
    packed.resize(stored);
    EXPECT_EQ(packed, wanted);
  }
}

// Numbers that a To can hold: any float or double may become another.
template <class From, class To>
From convertible(std::uint64_t i) {
  if constexpr (std::is_integral_v<From>)
    return whole<From>(i);
  else if constexpr (std::is_integral_v<To>)
    return static_cast<From>(any_bits<std::int32_t>(i)) / From(1 << (i % 31));
  else
    return any_bits<From>(i);
}

template <class From, class To, int W>
void expect_each_converted() {
  for (std::uint64_t start = 0; start < 3000; ++start) {
    Lanes<From, W> from;
    for (int i = 0; i < W; ++i)
      from.set(i, convertible<From, To>(W * start + static_cast<std::uint64_t>(i)));
    const Lanes<To, W> to(from);
    for (int i = 0; i < W; ++i) {
      const To one = static_cast<To>(from[i]);
      ASSERT_TRUE(to[i] == one || (to[i] != to[i] && one != one)) << from[i] << " became " << to[i];
    }
  }
}
template <class From, class To>
void expect_converted() {
  expect_each_converted<From, To, 2>();
  expect_each_converted<From, To, 4>();
  expect_each_converted<From, To, 8>();
  expect_each_converted<From, To, 16>();
}

TEST(Conversions, AmongReals) {
  expect_converted<float, double>();
  expect_converted<double, float>();
}
TEST(Conversions, FromRealsToWholes) {
  expect_converted<double, std::int64_t>();
  expect_converted<double, std::int32_t>();
  expect_converted<float, std::int32_t>();
}
TEST(Conversions, FromWholesToReals) {
  expect_converted<std::int64_t, double>();
  expect_converted<std::int32_t, double>();
  expect_converted<std::int32_t, float>();
  expect_converted<std::uint32_t, double>();
  expect_converted<std::uint32_t, float>();
}
TEST(Conversions, AmongWholes) {
  expect_converted<std::uint32_t, std::uint64_t>();
  expect_converted<std::uint64_t, std::uint32_t>();
  expect_converted<std::int32_t, std::int64_t>();
  expect_converted<std::int64_t, std::int32_t>();
}

// float and double lanes, of every width.
template <class L>
class OfRealLanes : public testing::Test {};
using Reals = testing::Types<Lanes<float, 2>, Lanes<float, 4>, Lanes<float, 8>, Lanes<float, 16>,
                             Lanes<float, 32>, Lanes<double, 2>, Lanes<double, 4>, Lanes<double, 8>,
                             Lanes<double, 16>>;
TYPED_TEST_SUITE(OfRealLanes, Reals);

TYPED_TEST(OfRealLanes, HalvesJoinToTheWhole) {
  const TypeParam whole_lanes = TypeParam::iota();
  const auto low = whole_lanes.low(), high = whole_lanes.high();
  for (int i = 0; i < TypeParam::kWidth / 2; ++i) {
    EXPECT_TRUE(low[i] == i);
    EXPECT_TRUE(high[i] == i + TypeParam::kWidth / 2);
  }
  EXPECT_TRUE(all(TypeParam::joined(low, high) == whole_lanes));
}

TYPED_TEST(OfRealLanes, SignsAreOfZerosAndNaNsToo) {
  using Number = typename TypeParam::Scalar;
  const double numbers[] = {0.0,
                            -0.0,
                            1,
                            -1,
                            std::numeric_limits<double>::quiet_NaN(),
                            -std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};
  TypeParam x;
  for (int start = 0; start < 8; ++start) {
    for (int i = 0; i < TypeParam::kWidth; ++i)
      x.set(i, static_cast<Number>(numbers[(start + i) % 8]));
    const auto signs = ScalarTraits<TypeParam>::sign_bit(x);
    for (int i = 0; i < TypeParam::kWidth; ++i)
      EXPECT_EQ(signs[i], ScalarTraits<Number>::sign_bit(x[i])) << "lane " << i;
  }
}

TYPED_TEST(OfRealLanes, GatherReadsNothingOutsideOfTheMask) {
  using Number = typename TypeParam::Scalar;
  constexpr int kLanes = TypeParam::kWidth;
  const auto expect = [](auto far_away) {
    using Index = decltype(far_away);
    std::vector<Number> table;
    for (int i = 0; i < 64; ++i)
      table.push_back(static_cast<Number>(3 * i));
    Lanes<Index, kLanes> index;
    auto mask = typename TypeParam::Mask(true);
    for (int i = 0; i < kLanes; ++i)
      index.set(i, i % 3 == 1 ? far_away : static_cast<Index>(63 - i));
    mask = mask && index != Lanes<Index, kLanes>(far_away);
    const TypeParam found = TypeParam::gather(&table[0], index, mask);
    for (int i = 0; i < kLanes; ++i)
      EXPECT_TRUE(found[i] == (i % 3 == 1 ? Number(0) : Number(3 * (63 - i)))) << "lane " << i;
  };
  if constexpr (sizeof(Number) == 4)
    expect(std::int32_t{1} << 30);
  else
    expect(std::int64_t{1} << 50);
}

}  // namespace
}  // namespace alhazen::render
