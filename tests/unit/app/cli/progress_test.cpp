#include "app/cli/progress.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace alhazen {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

ProgressMeter meter(ProgressStyle style, int columns = 80) {
  return ProgressMeter(style, {"frame 7", 2, 20}, columns);
}

TEST(Progress, DurationsAreMinutesOrHours) {
  EXPECT_EQ(format_duration(0), "0:00");
  EXPECT_EQ(format_duration(7.4), "0:07");
  EXPECT_EQ(format_duration(754), "12:34");
  EXPECT_EQ(format_duration(3723), "1:02:03");
}

TEST(Progress, PlainLinesAreWhatFarmsLookFor) {
  ProgressMeter plain = meter(ProgressStyle::plain);
  EXPECT_EQ(plain.update(42, 100, 4.2), "frame 7 (3 of 20): 42% done, 0:06 left\n");
}

TEST(Progress, PlainLinesComeWithTimeAndProgressTogether) {
  ProgressMeter plain = meter(ProgressStyle::plain);
  EXPECT_EQ(plain.update(500, 1000, 1.9), "") << "too soon";
  EXPECT_NE(plain.update(500, 1000, 2.0), "");
  EXPECT_EQ(plain.update(509, 1000, 9.0), "") << "less than a per cent";
  EXPECT_NE(plain.update(510, 1000, 9.0), "");
  EXPECT_EQ(plain.update(1000, 1000, 9.1), "frame 7 (3 of 20): 100% done, 0:09 taken\n");
  EXPECT_EQ(plain.update(1000, 1000, 20), "") << "the end is said once";
}

TEST(Progress, HundredPerCentMeansDone) {
  ProgressMeter plain = meter(ProgressStyle::plain);
  EXPECT_THAT(plain.update(9999, 10000, 5), HasSubstr(" 99% done"));
}

TEST(Progress, BarFitsItsTerminalAndIsClearedAtTheEnd) {
  for (const int columns : {10, 20, 40, 80, 200}) {
    ProgressMeter bar = meter(ProgressStyle::bar, columns);
    const std::string drawn = bar.update(1, 2, 60);
    ASSERT_THAT(drawn, StartsWith("\r\x1b[K"));
    if (columns >= 20) {
      EXPECT_LT(drawn.size() - 4, static_cast<std::size_t>(columns)) << drawn;
    }
    EXPECT_THAT(drawn, EndsWith(" 50% 1:00 left"));
    EXPECT_EQ(bar.update(2, 2, 120), "\r\x1b[K");
    EXPECT_EQ(bar.clear(), "") << "nothing is left to clear";
  }
}

TEST(Progress, BarIsNotRedrawnFasterThanAnEyeSees) {
  ProgressMeter bar = meter(ProgressStyle::bar);
  EXPECT_NE(bar.update(1, 1000, 0.1), "");
  EXPECT_EQ(bar.update(2, 1000, 0.15), "");
  EXPECT_EQ(bar.clear(), "\r\x1b[K");
}

TEST(Progress, JsonIsOneObjectALine) {
  ProgressMeter json = meter(ProgressStyle::json);
  const std::string line = json.update(250, 1000, 5);
  ASSERT_THAT(line, EndsWith("}\n"));
  EXPECT_EQ(std::ranges::count(line, '\n'), 1);
  const auto event = nlohmann::json::parse(line);
  EXPECT_EQ(event.at("percent"), 25.0);
  EXPECT_EQ(event.at("seconds_left"), 15.0);
  EXPECT_EQ(event.at("label"), "frame 7");
}

TEST(Progress, NoneIsSilent) {
  ProgressMeter none = meter(ProgressStyle::none);
  EXPECT_EQ(none.update(1, 2, 10), "");
  EXPECT_EQ(none.update(2, 2, 20), "");
}

}  // namespace
}  // namespace alhazen
