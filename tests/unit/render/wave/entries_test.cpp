// Lanes of a queue's entries: loaded or gathered, the same numbers; stored in their order.
#include "render/wave/entries.h"

#include <gtest/gtest.h>

namespace alhazen::render {
namespace {

template <class T>
class EntriesOf : public ::testing::Test {};
using Types = ::testing::Types<Lanes<double, 2>, Lanes<double, 4>, Lanes<double, 8>,
                               Lanes<float, 4>, Lanes<float, 16>>;
TYPED_TEST_SUITE(EntriesOf, Types);

// A column of 0, 10, 20, ...
template <class Real>
Column<Real> tens(std::size_t count) {
  Column<Real> column;
  column.make_room(count);
  for (std::size_t i = 0; i < count; ++i)
    column[i] = static_cast<Real>(10 * i);
  return column;
}

TYPED_TEST(EntriesOf, ARowIsWhatIsThere) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  const std::size_t count = 2 * L::kWidth + 1;
  const Column<Real> column = tens<Real>(count);
  std::size_t seen = 0;
  for_lanes<L>(count, [&](const Entries<L>& at) {
    const L numbers = at.of(column);
    for_each_lane(at.active(), [&](int k) {
      EXPECT_EQ(at[k], seen);
      EXPECT_EQ(numbers[k], static_cast<Real>(10 * seen));
      ++seen;
    });
  });
  EXPECT_EQ(seen, count);
}

TYPED_TEST(EntriesOf, AListNamesAny) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  const Column<Real> column = tens<Real>(100);
  IndexList<LaneInt<Real>> list;
  list.make_room(L::kWidth + 3);
  for (std::size_t k = 0; k < L::kWidth + 3; ++k)
    list.push(k < 2 ? k : 97 - 5 * k);
  std::size_t seen = 0;
  for_lanes<L>(list, [&](const Entries<L>& at) {
    const L numbers = at.of(column);
    for_each_lane(at.active(), [&](int k) {
      EXPECT_EQ(numbers[k], static_cast<Real>(10 * list[seen]));
      ++seen;
    });
  });
  EXPECT_EQ(seen, list.size());
}

TYPED_TEST(EntriesOf, LanesAreStoredInTheirOrder) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  RgbColumn<Real> column;
  column.make_room(L::kWidth);
  const auto odd = MaskOf<L>::from_bits(0xaaaaaaaau);
  const L numbers = L::iota();
  store_lanes(odd, Rgb<L>(numbers, numbers + L(100), numbers + L(200)), column, 1);
  for (std::size_t k = 0; k < L::kWidth / 2; ++k) {
    const Real lane = static_cast<Real>(2 * k + 1);
    EXPECT_EQ(column[k + 1], Rgb<Real>(lane, lane + 100, lane + 200));
  }
}

TYPED_TEST(EntriesOf, NumbersFoundOneByOne) {
  using L = TypeParam;
  using Real = ScalarOf<L>;
  const auto even = MaskOf<L>::from_bits(0x55555555u);
  const L found = per_lane<L>(even, Real(-1), [](int k) { return static_cast<Real>(k * k); });
  for (int k = 0; k < L::kWidth; ++k)
    EXPECT_EQ(found[k], k % 2 == 0 ? static_cast<Real>(k * k) : Real(-1));
}

}  // namespace
}  // namespace alhazen::render
