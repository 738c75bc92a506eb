#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/study/report_data.h"
#include "app/study/report_page.h"
#include "app/study/study_charts.h"
#include "unit/app/study/studies.h"

namespace alhazen {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(StudyPage, StandsAloneAndEscapesNames) {
  const auto page = study_page(small_study());
  ASSERT_TRUE(page);
  const std::string& html = page.value();
  EXPECT_THAT(html, HasSubstr("two &lt;balls&gt; &amp; &quot;more&quot;"));
  EXPECT_THAT(html, Not(HasSubstr("<balls>")));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http://")), Not(HasSubstr("https://"))));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(html, HasSubstr("no light with a face casts shadows"));
}

TEST(StudyPage, EveryPointHasItsTwoPictures) {
  const SceneStudy study = small_study();
  const auto page = study_page(study);
  ASSERT_TRUE(page);
  EXPECT_EQ(count_of(page.value(), "<figure id=\"p"), study.points.size());
  EXPECT_EQ(count_of(page.value(), "<img src=\"data:image/png;base64,"), 2 * study.points.size());
}

TEST(StudyPage, PointBelowTheFloorIsOnNoChartAndTheTableSaysSo) {
  const auto page = study_page(small_study());
  ASSERT_TRUE(page);
  EXPECT_EQ(count_of(page.value(), "href=\"#p5\""), 0u);
  EXPECT_GT(count_of(page.value(), "href=\"#p3\""), 0u);
  EXPECT_THAT(page.value(), HasSubstr("1 point on the charts"));
}

TEST(StudyCharts, SamePictureOnTwoCurvesIsInThePageOnce) {
  SceneStudy study = small_study();
  StudyPoint twin = study.points[1];
  twin.setting.knob = Knob::filter;
  study.points.push_back(twin);
  EXPECT_EQ(picture_ids(study).back(), "p1");
}

TEST(StudyIndex, LeadsToEachPage) {
  const SceneStudy a = small_study("a"), b = study_with_povray();
  const IndexEntry entries[] = {{a, "a.html"}, {b, "b.html"}};
  const auto page = study_index(entries);
  ASSERT_TRUE(page);
  EXPECT_THAT(page.value(), AllOf(HasSubstr("href=\"a.html\""), HasSubstr("href=\"b.html\"")));
  EXPECT_THAT(page.value(), HasSubstr("The same error in POV-Ray"));
}

TEST(StudyCsv, EveryLineHasTheColumnsOfTheHeading) {
  SceneStudy study = study_with_povray();
  study.name = "plain";
  std::istringstream lines(study_csv(study));
  std::string line;
  std::getline(lines, line);
  const auto columns = std::ranges::count(line, ',');
  std::size_t points = 0;
  // No setting of this study has a comma in its text.
  for (; std::getline(lines, line); ++points)
    EXPECT_EQ(std::ranges::count(line, ','), columns) << line;
  EXPECT_EQ(points, study.points.size());
}

TEST(StudyCsv, QuotesStandInQuotes) {
  EXPECT_THAT(study_csv(small_study()), HasSubstr("\"two <balls> & \"\"more\"\"\","));
}

TEST(StudyJson, HasWhatThePageShows) {
  const auto json = study_json(study_with_povray());
  EXPECT_EQ(json["points"].size(), 10u);
  EXPECT_EQ(json["points"][2]["scene"], true);
  EXPECT_EQ(json["points"][5]["shown"], false);
  EXPECT_EQ(json["front"].size(), 4u);
  EXPECT_EQ(json["reference"]["samples"], 4096);
  EXPECT_NEAR(json["povray"]["equal_error"][0]["ratio"].get<double>(), 3, 1e-9);
  EXPECT_EQ(json["left_out"][0]["what"], "light samples");
}

TEST(StudyTable, FitsATerminalAndMarksTheFront) {
  const std::string table = study_table(study_with_povray());
  EXPECT_THAT(table, HasSubstr(" * 16 samples"));
  EXPECT_THAT(table, HasSubstr("   8 samples"));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    const auto letters = std::ranges::count_if(line, [](char c) { return (c & 0xc0) != 0x80; });
    EXPECT_LE(letters, 100) << line;
  }
}

}  // namespace
}  // namespace alhazen
