#include "render/film/first_look.h"

#include <gtest/gtest.h>

namespace alhazen::render {
namespace {

constexpr int kWidth = 8, kHeight = 6;

FirstLook look_at(const std::vector<float>& values) {
  FirstLook look(ErrorLoss({1.0 / 64, 0}), kWidth, kHeight);
  for (std::size_t p = 0; p < values.size(); ++p)
    look.set(p, {values[p], values[p], values[p]});
  return look;
}

TEST(FirstLook, OneColourDiffersNowhere) {
  const FirstLook look = look_at(std::vector<float>(kWidth * kHeight, 0.7F));
  for (std::size_t p = 0; p < kWidth * kHeight; ++p)
    EXPECT_EQ(look.difference(p), 0);
}

// All eight neighbours differ from a dot by 1, and from the pixel beside it one of weight 2 in 12.
TEST(FirstLook, ADotDiffersFromAllAround) {
  std::vector<float> values(kWidth * kHeight, 0);
  const std::size_t dot = 2 * kWidth + 3;
  values[dot] = 1;
  const FirstLook look = look_at(values);
  EXPECT_EQ(look.difference(dot), 0.5);
  EXPECT_DOUBLE_EQ(look.difference(dot + 1), 1.0 / 12);
  EXPECT_DOUBLE_EQ(look.difference(dot + kWidth + 1), 1.0 / 24);
  EXPECT_EQ(look.difference(dot + 2), 0);
  // As if it had been dark.
  EXPECT_EQ(look.difference(dot, {0, 0, 0}), 0);
}

TEST(FirstLook, APixelAloneHasNoNeighbours) {
  FirstLook look(ErrorLoss({1.0 / 64, 0}), 1, 1);
  look.set(0, {3, 4, 5});
  EXPECT_EQ(look.difference(0), 0);
}

}  // namespace
}  // namespace alhazen::render
