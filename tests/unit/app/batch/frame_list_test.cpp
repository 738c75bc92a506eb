#include "app/batch/frame_list.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>

namespace alhazen {
namespace {

std::vector<int> frames(std::string_view text) {
  const Result<std::vector<int>> parsed = parse_frame_list(text);
  EXPECT_TRUE(parsed) << text;
  return parsed ? parsed.value() : std::vector<int>{};
}

using Frames = std::vector<int>;

TEST(FrameList, RangesStepsAndLists) {
  EXPECT_EQ(frames("7"), (Frames{7}));
  EXPECT_EQ(frames("1-4"), (Frames{1, 2, 3, 4}));
  EXPECT_EQ(frames("1-10x4"), (Frames{1, 5, 9}));
  EXPECT_EQ(frames("4-1"), (Frames{4, 3, 2, 1}));
  EXPECT_EQ(frames("10-1x4"), (Frames{10, 6, 2}));
  EXPECT_EQ(frames("-5--3"), (Frames{-5, -4, -3}));
  EXPECT_EQ(frames("-2-1"), (Frames{-2, -1, 0, 1}));
  EXPECT_EQ(frames("9,1-3,2-5"), (Frames{9, 1, 2, 3, 4, 5}));
}

TEST(FrameList, NonsenseIsAUsageError) {
  for (const char* text : {"", ",", "1,", "1-", "a", "1-2-3", "1-10x0", "1-10x-2", "1x2", "1 - 2",
                           "1.5", "+1", "99999999", "1-99999999999", "0x10"}) {
    const Result<Frames> parsed = parse_frame_list(text);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.error().code, ErrorCode::usage) << text;
  }
}

TEST(FrameList, ColonIsRefusedWithBothReadings) {
  const Result<Frames> parsed = parse_frame_list("1-10:2");
  ASSERT_FALSE(parsed);
  EXPECT_EQ(parsed.error().code, ErrorCode::usage);
  EXPECT_NE(parsed.error().message.find("step"), std::string::npos);
  EXPECT_NE(parsed.error().message.find("interleaving"), std::string::npos);
}

TEST(FrameList, AMillionFramesAndNoMore) {
  EXPECT_EQ(frames("1-1000000").size(), kMaxFrames);
  EXPECT_EQ(parse_frame_list("0-1000000").error().code, ErrorCode::limit);
}

TEST(FrameList, CanonicalForm) {
  EXPECT_EQ(format_frame_list({1, 2, 3, 9}), "1-3,9");
  EXPECT_EQ(format_frame_list({1, 6, 11}), "1-11x5");
  EXPECT_EQ(format_frame_list({5, 3}), "5,3");
  EXPECT_EQ(format_frame_list({-1, -2}), "-1--2");
}

RC_GTEST_PROP(FrameList, WhatIsWrittenIsReadBack, ()) {
  const auto drawn = *rc::gen::unique<Frames>(rc::gen::inRange(-kMaxFrame, kMaxFrame + 1));
  RC_PRE(!drawn.empty());
  RC_ASSERT(frames(format_frame_list(drawn)) == drawn);
}

RC_GTEST_PROP(FrameList, RunsAreReadBackToo, ()) {
  // Few distinct frames, so that runs do occur.
  const auto drawn =
      *rc::gen::unique<Frames>(*rc::gen::inRange<std::size_t>(1, 12), rc::gen::inRange(-8, 9));
  RC_ASSERT(frames(format_frame_list(drawn)) == drawn);
}

RC_GTEST_PROP(FrameList, ARangeHoldsItsEndsAndNothingBeyond, ()) {
  const int first = *rc::gen::inRange(-1000, 1000);
  const int last = *rc::gen::inRange(-1000, 1000);
  const int step = *rc::gen::inRange(1, 50);
  const Frames list =
      frames(std::to_string(first) + "-" + std::to_string(last) + "x" + std::to_string(step));
  const auto [low, high] = std::minmax(first, last);
  RC_ASSERT(list.front() == first);
  RC_ASSERT(list.size() == static_cast<std::size_t>((high - low) / step + 1));
  RC_ASSERT(std::ranges::all_of(list, [&](int f) { return low <= f && f <= high; }));
}

RC_GTEST_PROP(FrameList, AnyBytesAreReadOrRefused, (const std::string& text)) {
  const Result<Frames> parsed = parse_frame_list(text);
  if (!parsed) RC_SUCCEED("refused");
  const std::set<int> distinct(parsed.value().begin(), parsed.value().end());
  RC_ASSERT(distinct.size() == parsed.value().size());
}

}  // namespace
}  // namespace alhazen
