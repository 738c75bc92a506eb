#include "app/batch/frame_name.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alhazen {
namespace {

std::string name(std::string_view pattern, int frame) {
  const Result<std::string> result = frame_name(pattern, frame);
  EXPECT_TRUE(result) << pattern;
  return result ? result.value() : "";
}

TEST(FrameName, HashesAndPercentAreFilled) {
  EXPECT_EQ(name("a.####.exr", 7), "a.0007.exr");
  EXPECT_EQ(name("a.%04d.exr", 7), "a.0007.exr");
  EXPECT_EQ(name("a%d.exr", 7), "a7.exr");
  EXPECT_EQ(name("a.#.exr", 12345), "a.12345.exr");
  EXPECT_EQ(name("a.####.exr", -7), "a.-0007.exr");
  EXPECT_EQ(name("50%/a.##", 3), "50%/a.03");
}

TEST(FrameName, NoPlaceOrTwoPlacesAreUsageErrors) {
  for (const char* pattern : {"a.exr", "%", "%x.exr", "a.##.##", "%d_####", "%05"}) {
    const Result<std::string> result = frame_name(pattern, 1);
    ASSERT_FALSE(result) << pattern;
    EXPECT_EQ(result.error().code, ErrorCode::usage);
  }
  EXPECT_EQ(frame_place("a.exr"), "");
  EXPECT_EQ(frame_place("a.#.exr"), "#");
  EXPECT_EQ(frame_place("a.%04d.exr"), "%04d");
}

RC_GTEST_PROP(FrameName, DifferentFramesHaveDifferentNames, ()) {
  const int a = *rc::gen::inRange(-100000, 100000);
  const int b = *rc::gen::inRange(-100000, 100000);
  const std::string pattern = "p." + std::string(*rc::gen::inRange<std::size_t>(1, 7), '#');
  RC_ASSERT((name(pattern, a) == name(pattern, b)) == (a == b));
}

}  // namespace
}  // namespace alhazen
