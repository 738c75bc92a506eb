#include "core/base/near_name.h"

#include <array>
#include <gtest/gtest.h>

namespace alhazen {
namespace {

TEST(EditDistance, CountsSingleChanges) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("radius", "radisu"), 1u);
  EXPECT_EQ(edit_distance("color", "colour"), 1u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // not 2: no character is touched twice
}

constexpr std::array<std::string_view, 4> kNames = {"radius", "center", "material", "n"};

TEST(NearName, MisspellingsAreFound) {
  EXPECT_EQ(near_name("raduis", kNames), "radius");
  EXPECT_EQ(near_name("centre", kNames), "center");
  EXPECT_EQ(near_name("MATERIAL", kNames), "material");
  EXPECT_EQ(near_name("N", kNames), "n");
}

TEST(NearName, StrangersAreNot) {
  EXPECT_EQ(near_name("", kNames), std::nullopt);
  EXPECT_EQ(near_name("x", kNames), std::nullopt);
  EXPECT_EQ(near_name("velocity", kNames), std::nullopt);
  EXPECT_EQ(near_name("radius", {}), std::nullopt);
}

}  // namespace
}  // namespace alhazen
