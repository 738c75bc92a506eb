#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/povray/report_page.h"
#include "render/color/color_config.h"

namespace alhazen {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kHostile = "</pre><script>alert('x')</script>\"&";
constexpr const char* kEscaped =
    "&lt;/pre&gt;&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&quot;&amp;";

CheckOutcome outcome(const std::string& name, bool passes, const std::string& text = "") {
  CrossCheck check;
  check.name = name;
  check.scene_text = text;
  check.ours = render::FloatBuffer(4, 3, {"R", "G", "B"});
  check.deviation_texts = {"not exact " + text};
  Witness witness{"exported", text, check.ours, {1.5, 0.75, 0.25, 0.25, ""}, {}};
  witness.verdict.passes = passes;
  witness.verdict.sentence = "as it is " + text;
  witness.verdict.channels = 36;
  if (!passes) {
    witness.verdict.over = 1;
    witness.verdict.rmse = 0.5;
    witness.verdict.pixels = {{{3, 2}, {0.5F, 0, 0}, {0, 0, 0}, 0.5, Cause::unexplained}};
  }
  check.witnesses.push_back(std::move(witness));
  return {name, std::move(check)};
}

std::string page(const std::vector<CheckOutcome>& outcomes) {
  const auto colors = render::ColorConfig::builtin();
  const auto view = colors.value().display_transform("", "");
  const auto text = report_page(outcomes, view.value());
  EXPECT_TRUE(text);
  return text ? text.value() : "";
}

TEST(ReportPage, HasEachScene) {
  const std::string text = page({outcome("first", true),
                                 outcome("second", false),
                                 {"third", Error{ErrorCode::io, "no picture"}}});
  EXPECT_THAT(text, AllOf(HasSubstr("id=\"first\""), HasSubstr("id=\"second\""), HasSubstr("third"),
                          HasSubstr("DIFFERENT"), HasSubstr("FAILED: no picture"),
                          HasSubstr("1 of 3 scenes"), HasSubstr("(3, 2) unexplained")));
}

TEST(ReportPage, TextOfScenesStaysText) {
  CheckOutcome hostile = outcome(kHostile, false, kHostile);
  const std::string text = page({hostile, {kHostile, Error{ErrorCode::usage, kHostile}}});
  EXPECT_THAT(text, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(text, HasSubstr(std::string("as it is ") + kEscaped));
  EXPECT_THAT(text, HasSubstr(std::string("not exact ") + kEscaped));
  EXPECT_THAT(text, HasSubstr(std::string("FAILED: ") + kEscaped));
}

TEST(ReportPage, OfNothingIsAPage) {
  EXPECT_THAT(page({}), HasSubstr("0 of 0 scenes"));
}

TEST(ReportJson, HoldsTheFigures) {
  const auto json = nlohmann::json::parse(report_json(
      {outcome("first", true), outcome("second", false), {"third", Error{ErrorCode::io, "none"}}}));
  ASSERT_EQ(json["scenes"].size(), 3U);
  EXPECT_EQ(json["scenes"][0]["same"], true);
  const auto& second = json["scenes"][1];
  EXPECT_EQ(second["same"], false);
  EXPECT_EQ(second["witnesses"][0]["rmse"], 0.5);
  EXPECT_EQ(second["witnesses"][0]["povray_wall_seconds"], 1.5);
  EXPECT_EQ(second["witnesses"][0]["povray_cpu_seconds"], 0.75);
  EXPECT_EQ(second["witnesses"][0]["povray_trace_seconds"], 0.25);
  const auto& pixel = second["witnesses"][0]["pixels"][0];
  EXPECT_EQ(pixel["x"], 3);
  EXPECT_EQ(pixel["y"], 2);
  EXPECT_EQ(pixel["cause"], "unexplained");
  EXPECT_EQ(pixel["ours"], (std::vector<float>{0.5F, 0, 0}));
  EXPECT_EQ(json["scenes"][2]["same"], false);
  EXPECT_EQ(json["scenes"][2]["error"], "none");
}

// JSON knows no NaN and no bytes that are not UTF-8: null, and the mark for what is unreadable.
TEST(ReportJson, IsJsonWhateverIsInIt) {
  CheckOutcome odd = outcome("a\xff\n\"", false, "\xc3");
  odd.check.value().witnesses[0].verdict.rmse = std::nan("");
  odd.check.value().witnesses[0].verdict.pixels[0].ours.r = INFINITY;
  const auto json =
      nlohmann::json::parse(report_json({odd, {"\xfe", Error{ErrorCode::io, "\xfd"}}}));
  EXPECT_EQ(json["scenes"][0]["scene"], "a\ufffd\n\"");
  EXPECT_TRUE(json["scenes"][0]["witnesses"][0]["rmse"].is_null());
  EXPECT_EQ(report_json({}), "{\n  \"scenes\": []\n}\n");
}

}  // namespace
}  // namespace alhazen
