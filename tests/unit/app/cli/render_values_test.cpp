#include "app/cli/render_values.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace alhazen {
namespace {

template <class T>
void expect_usage_error(const Result<T>& result, const std::string& text) {
  ASSERT_FALSE(result) << text;
  EXPECT_EQ(result.error().code, ErrorCode::usage) << text;
  EXPECT_NE(result.error().message.find("`" + text + "`"), std::string::npos)
      << result.error().message;
}

TEST(RenderValues, Sizes) {
  EXPECT_EQ(to_size("1920x1080").value().width, 1920);
  EXPECT_EQ(to_size("1920x1080").value().height, 1080);
  for (const char* text : {"", "x", "10", "0x5", "5x0", "-1x5", "5x5x5", "5 x 5", "1e3x5", "5X5",
                           "99999999x1", "99999999999999999999x1"}) {
    expect_usage_error(to_size(text), text);
  }
}

TEST(RenderValues, Crops) {
  EXPECT_EQ(to_crop("1,2,3,4").value().height, 4);
  for (const char* text : {"", "1,2,3", "1,2,3,4,5", "0,0,0,4", "-1,0,4,4", "a,b,c,d"}) {
    expect_usage_error(to_crop(text), text);
  }
}

TEST(RenderValues, Defines) {
  EXPECT_EQ(to_define("a_1=b = c").value().name, "a_1");
  EXPECT_EQ(to_define("a_1=b = c").value().text, "b = c");
  for (const char* text : {"", "a", "a=", "=1", "1a=1", "a b=1", "a-b=1"}) {
    expect_usage_error(to_define(text), text);
  }
}

TEST(RenderValues, FiltersHaveTheirUsualRadiusOrTheirOwn) {
  EXPECT_EQ(to_filter("box").value().radius, 0.5);
  EXPECT_EQ(to_filter("mitchell").value().radius, 2);
  EXPECT_EQ(to_filter("gaussian:2.5").value().radius, 2.5);
  EXPECT_FALSE(to_filter("gaussian:"));
  EXPECT_FALSE(to_filter("gaussian:nan"));
  EXPECT_FALSE(to_filter("tent:0"));
  EXPECT_THAT(to_filter("gausian").error().message, testing::HasSubstr("did you mean `gaussian`"));
}

TEST(RenderValues, AovListsAreReadAndNamed) {
  EXPECT_EQ(aov_names(to_aovs("normal,depth").value()),
            (std::vector<std::string>{"depth", "normal"}));
  EXPECT_EQ(aov_names(to_aovs("all").value()).size(), 9u);
  const render::AovRequest decisions = to_aovs("signature,margin").value();
  EXPECT_TRUE(decisions.signature && decisions.margin && !decisions.depth);
  EXPECT_FALSE(to_aovs("all").value().signature || to_aovs("all").value().margin);
  EXPECT_TRUE(to_aovs("all,margin").value().margin);
  EXPECT_FALSE(to_aovs("none").value().any());
  EXPECT_FALSE(to_aovs("depth,"));
  EXPECT_THAT(to_aovs("normals").error().message, testing::HasSubstr("did you mean `normal`"));
}

TEST(RenderValues, NamesAreReadBack) {
  for (const char* text : {"float", "double", "quad"}) {
    EXPECT_EQ(name(to_precision(text).value()), text);
  }
  for (const char* text : {"box", "tent", "gaussian", "mitchell"}) {
    EXPECT_EQ(name(to_filter(text).value().kind), text);
  }
}

RC_GTEST_PROP(RenderValues, AnyBytesAreReadOrRefused, (const std::string& text)) {
  const auto size = to_size(text);
  const auto crop = to_crop(text);
  const auto filter = to_filter(text);
  const auto define = to_define(text);
  // Inside of RC_ASSERT `||` would not stop at its left operand.
  if (size) RC_ASSERT(size.value().width > 0 && size.value().height > 0);
  if (crop) RC_ASSERT(crop.value().width > 0 && crop.value().x >= 0);
  if (filter) RC_ASSERT(filter.value().radius > 0);
  if (define) RC_ASSERT(!define.value().name.empty());
}

}  // namespace
}  // namespace alhazen
