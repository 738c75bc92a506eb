#include "app/compare/pairing.h"

#include <gmock/gmock.h>

#include "unit/app/compare/pictures.h"

namespace alhazen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Pairing pair(const ComparedPicture& a, const ComparedPicture& b,
             const std::vector<std::string>& channels = {}) {
  const Result<Pairing> result = pair_pictures(a, b, channels);
  EXPECT_TRUE(result);
  return result ? result.value() : Pairing{};
}

std::vector<std::string> names(const PartPair& parts) {
  std::vector<std::string> result;
  for (const ChannelPair& channel : parts.channels)
    result.push_back(channel.name);
  return result;
}

TEST(Pairing, PartsAndChannelsMeetByName) {
  const auto a = test_picture({test_part("rgba", {"A", "B", "G", "R"}), test_part("data", {"Z"})});
  const auto b = test_picture({test_part("data", {"Z"}), test_part("rgba", {"R", "B", "A", "G"})});
  const Pairing pairing = pair(a, b);
  EXPECT_THAT(pairing.differences, IsEmpty());
  EXPECT_THAT(pairing.notes, IsEmpty());
  ASSERT_EQ(pairing.parts.size(), 2u);
  EXPECT_THAT(names(pairing.parts[0]), ElementsAre("R", "G", "B", "A"));
  EXPECT_EQ(pairing.parts[0].channels[0].a, 3u);
  EXPECT_EQ(pairing.parts[0].channels[0].b, 0u);
  EXPECT_EQ(pairing.parts[1].b, &b.parts[0]);
}

TEST(Pairing, SoleNamelessPartMeetsTheFirst) {
  const auto a = test_picture({test_part("rgba", {"B", "G", "R"}), test_part("data", {"Z"})});
  const auto b = test_picture({test_part("", {"B", "G", "R"})});
  const Pairing there = pair(a, b), back = pair(b, a);
  for (const Pairing& pairing : {there, back}) {
    ASSERT_EQ(pairing.parts.size(), 1u);
    EXPECT_THAT(pairing.notes, ElementsAre(HasSubstr("the part without a name")));
    EXPECT_THAT(pairing.differences, ElementsAre(HasSubstr("part `data` is in")));
  }
}

TEST(Pairing, PartsOfOtherNamesDoNotMeet) {
  const auto a = test_picture({test_part("left", {"R"})});
  const auto b = test_picture({test_part("right", {"R"})});
  const Pairing pairing = pair(a, b);
  EXPECT_THAT(pairing.parts, IsEmpty());
  EXPECT_THAT(pairing.differences, ElementsAre(HasSubstr("part `left` is in A only (R)"),
                                               HasSubstr("part `right` is in B only (R)")));
}

TEST(Pairing, CommonChannelsAreComparedAndOthersNamed) {
  const auto a = test_picture({test_part("", {"B", "G", "R", "Z"})});
  const auto b = test_picture({test_part("", {"A", "B", "G", "N.X", "N.Y", "P.X", "R"})});
  const Pairing pairing = pair(a, b);
  ASSERT_EQ(pairing.parts.size(), 1u);
  EXPECT_THAT(names(pairing.parts[0]), ElementsAre("R", "G", "B"));
  EXPECT_THAT(pairing.differences,
              ElementsAre(HasSubstr("only A has the channel Z"),
                          HasSubstr("only B has the channels A, N.X .Y, P.X")));
}

TEST(Pairing, NoCommonChannelIsADifference) {
  const Pairing pairing =
      pair(test_picture({test_part("", {"R"})}), test_picture({test_part("", {"Z"})}));
  EXPECT_THAT(pairing.parts, IsEmpty());
  EXPECT_THAT(pairing.differences, testing::Contains(HasSubstr("no channel is in both")));
}

TEST(Pairing, OtherSizesAreNotCompared) {
  const Pairing pairing =
      pair(test_picture({test_part("", {"R"}, 4, 3)}), test_picture({test_part("", {"R"}, 3, 4)}));
  EXPECT_THAT(pairing.parts, IsEmpty());
  EXPECT_THAT(pairing.differences,
              testing::Contains(HasSubstr("A holds 4 x 3 pixels from (0, 0), B 3 x 4 pixels")));
}

TEST(Pairing, ACropElsewhereIsNotCompared) {
  auto b = test_picture({test_part("", {"R"})});
  b.parts[0].data_window.x = 7;
  const Pairing pairing = pair(test_picture({test_part("", {"R"})}), b);
  EXPECT_THAT(pairing.parts, IsEmpty());
  EXPECT_THAT(pairing.differences, ElementsAre(HasSubstr("from (7, 0)")));
}

TEST(Pairing, AnotherFrameAroundTheSamePixelsIsADifferenceButCompared) {
  auto b = test_picture({test_part("", {"R"})});
  b.parts[0].display_window.width = 100;
  const Pairing pairing = pair(test_picture({test_part("", {"R"})}), b);
  EXPECT_EQ(pairing.parts.size(), 1u);
  EXPECT_THAT(pairing.differences, ElementsAre(HasSubstr("the frame of A has 4 x 3")));
}

TEST(Pairing, OnlyWhatIsAskedForIsComparedAndMissed) {
  const auto a =
      test_picture({test_part("rgba", {"B", "G", "R"}), test_part("data", {"N.X", "Z"})});
  const auto b = test_picture({test_part("rgba", {"A", "B", "G", "R"})});
  const Pairing colors = pair(a, b, {"RGB"});
  EXPECT_THAT(colors.differences, IsEmpty());
  EXPECT_THAT(names(colors.parts.at(0)), ElementsAre("R", "G", "B"));
  EXPECT_THAT(names(pair(a, b, {"G"}).parts.at(0)), ElementsAre("G"));
  EXPECT_THAT(pair(a, b, {"G", "N"}).differences, ElementsAre(HasSubstr("is in A only (N.X)")));
}

TEST(Pairing, UnknownChannelIsAUsageErrorThatListsWhatThereIs) {
  const auto picture = test_picture({test_part("", {"N.X", "R"})});
  const Result<Pairing> result = pair_pictures(picture, picture, std::vector<std::string>{"zz"});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::usage);
  EXPECT_THAT(result.error().message, HasSubstr("`zz`; there are: N.X, N, R, RGB"));
}

TEST(Pairing, LightAndCodesAreNotCompared) {
  auto png = test_picture({test_part("", {"R", "G", "B"})});
  png.encoding = PixelEncoding::srgb;
  const auto exr = test_picture({test_part("", {"R", "G", "B"})});
  EXPECT_TRUE(pair_pictures(png, png, {}));
  const Result<Pairing> mixed = pair_pictures(exr, png, {});
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().code, ErrorCode::usage);
}

TEST(Pairing, PrimariesAreComparedWhereThereAreColours) {
  const char* kRec709Text = "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329";
  const char* kAp1Text = "0.713 0.293 0.165 0.83 0.128 0.044 0.32168 0.33767";
  auto a = test_picture({test_part("", {"B", "G", "R"})}), b = a;
  a.parts[0].attributes["chromaticities"] = kAp1Text;
  EXPECT_THAT(pair(a, b).notes, ElementsAre(HasSubstr("B does not say its primaries")));
  EXPECT_THAT(pair(a, b).differences, IsEmpty());
  b.parts[0].attributes["chromaticities"] = kRec709Text;
  EXPECT_THAT(pair(a, b).differences,
              ElementsAre(HasSubstr("equal numbers are different colours")));
  auto depth = test_picture({test_part("", {"Z"})}), other = depth;
  depth.parts[0].attributes["chromaticities"] = kAp1Text;
  other.parts[0].attributes["chromaticities"] = kRec709Text;
  EXPECT_THAT(pair(depth, other).differences, IsEmpty());
}

}  // namespace
}  // namespace alhazen
