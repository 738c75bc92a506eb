#include "app/povray/allowances.h"

#include <gmock/gmock.h>

namespace alhazen {
namespace {

using testing::HasSubstr;

TEST(Allowances, ReadsScenesWithTheirBoundAndReason) {
  const auto read = parse_allowances(
      R"({"a.scn": {"rmse": 0.5, "reason": "glass"}, "b.scn": {"reason": "x", "rmse": 2}})",
      "e.json");
  ASSERT_TRUE(read);
  ASSERT_EQ(read.value().size(), 2U);
  EXPECT_EQ(read.value().at("a.scn").rmse, 0.5);
  EXPECT_EQ(read.value().at("a.scn").reason, "glass");
  EXPECT_EQ(read.value().at("b.scn").rmse, 2);
  EXPECT_TRUE(parse_allowances("{}", "e.json"));
}

struct Wrong {
  const char* text;
  const char* message;
};

class WrongAllowances : public testing::TestWithParam<Wrong> {};

TEST_P(WrongAllowances, AreRefusedByName) {
  const auto read = parse_allowances(GetParam().text, "dir/expected.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::usage);
  EXPECT_THAT(read.error().message, testing::StartsWith("dir/expected.json: "));
  EXPECT_THAT(read.error().message, HasSubstr(GetParam().message));
}

constexpr const char* kTwoThings = "`a.scn` needs exactly two things";
INSTANTIATE_TEST_SUITE_P(
    All, WrongAllowances,
    testing::Values(
        Wrong{"", "a JSON object"}, Wrong{"{", "a JSON object"}, Wrong{"[]", "a JSON object"},
        Wrong{"3", "a JSON object"}, Wrong{"{} {}", "a JSON object"},
        Wrong{R"({"a.scn": {"rmse": 1e999, "reason": "x"}})", "a JSON object"},
        Wrong{"{\"a.scn\": {\"rmse\": 1, \"reason\": \"\xff\"}}", "a JSON object"},
        Wrong{R"({"a.scn": 0.1})", kTwoThings}, Wrong{R"({"a.scn": []})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": 1}})", kTwoThings},
        Wrong{R"({"a.scn": {"reason": "x"}})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": 1, "reason": "x", "more": 1}})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": 1, "raeson": "x"}})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": "1", "reason": "x"}})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": null, "reason": "x"}})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": 1, "reason": 2}})", kTwoThings},
        Wrong{R"({"a.scn": {"rmse": 0, "reason": "x"}})", "`rmse` of `a.scn` is not above 0"},
        Wrong{R"({"a.scn": {"rmse": -1, "reason": "x"}})", "`rmse` of `a.scn` is not above 0"},
        Wrong{R"({"a.scn": {"rmse": 1e-999, "reason": "x"}})", "`rmse` of `a.scn` is not above 0"},
        Wrong{R"({"a.scn": {"rmse": 1, "reason": ""}})", "`reason` of `a.scn` is empty"},
        Wrong{R"({"a.scn": {"rmse": 1, "reason": "x"}, "a.scn": {"rmse": 9, "reason": "y"}})",
              "`a.scn` is there twice"},
        Wrong{R"({"a.scn": {"rmse": 1, "rmse": 9, "reason": "y"}})", "`rmse` is there twice"}));

TEST(Allowances, ManyBracketsAreOnlyWrong) {
  EXPECT_FALSE(parse_allowances(std::string(1'000'000, '['), "e.json"));
}

}  // namespace
}  // namespace alhazen
