// A cheap variant against what std::variant promises, and that nothing it shares is lost or kept.
#include "core/base/cheap_variant.h"

#include <gtest/gtest.h>
#include <string>

namespace alhazen {
namespace {

struct Point {
  double x, y, z;
};
using Shared = std::shared_ptr<const int>;
using Any = CheapVariant<bool, double, Point, Shared, std::string>;

TEST(CheapVariant, IsTheFirstAlternativeAtFirst) {
  const Any nothing;
  EXPECT_EQ(nothing.index(), 0U);
  EXPECT_FALSE(nothing.get<bool>());
}

TEST(CheapVariant, HoldsWhatItWasGiven) {
  EXPECT_EQ(Any(2.5).get<double>(), 2.5);
  EXPECT_EQ(Any(2.5).index(), 1U);
  EXPECT_EQ(Any(Point{1, 2, 3}).get<Point>().z, 3);
  EXPECT_EQ(Any(std::string(40, 'a')).get<std::string>(), std::string(40, 'a'));
  EXPECT_THROW(Any(2.5).get<bool>(), std::bad_variant_access);
}

TEST(CheapVariant, VisitsWhatItHolds) {
  const auto size = [](const Any& any) {
    return any.visit([]<class T>(const T&) { return sizeof(T); });
  };
  EXPECT_EQ(size(true), sizeof(bool));
  EXPECT_EQ(size(Point{}), sizeof(Point));
  EXPECT_EQ(size(std::string()), sizeof(std::string));
}

TEST(CheapVariant, CopiesShareAndMovesHandOver) {
  const auto shared = std::make_shared<const int>(7);
  {
    Any a = Shared(shared);
    EXPECT_EQ(shared.use_count(), 2);
    const Any copy = a;
    EXPECT_EQ(shared.use_count(), 3);
    const Any moved = std::move(a);
    EXPECT_EQ(shared.use_count(), 3);
    EXPECT_EQ(moved.get<Shared>(), copy.get<Shared>());
  }
  EXPECT_EQ(shared.use_count(), 1);
}

TEST(CheapVariant, AssignmentReplacesWhateverWasThere) {
  const auto shared = std::make_shared<const int>(7);
  const Any values[] = {true, 2.5, Point{1, 2, 3}, Shared(shared), std::string(40, 'a')};
  for (const Any& from : values) {
    for (const Any& to : values) {
      Any copied = to, moved = to;
      copied = from;
      moved = Any(from);
      EXPECT_EQ(copied.index(), from.index());
      EXPECT_EQ(moved.index(), from.index());
    }
  }
  EXPECT_EQ(shared.use_count(), 2);
  Any self = std::string("itself");
  const Any& same = self;
  self = same;
  EXPECT_EQ(self.get<std::string>(), "itself");
}

}  // namespace
}  // namespace alhazen
