#include "app/study/budget.h"

#include <gmock/gmock.h>

namespace alhazen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// One second a sample.
constexpr PilotCost kCost{0, 1, 0, 1};

StudySetting of_samples(int samples, int rank, bool is_scene = false) {
  StudySetting setting;
  setting.settings.samples = samples;
  setting.label = std::to_string(samples);
  setting.rank = rank;
  setting.is_scene = is_scene;
  return setting;
}

std::vector<std::string> labels(const std::vector<StudySetting>& settings) {
  std::vector<std::string> out;
  for (const StudySetting& setting : settings)
    out.push_back(setting.label);
  return out;
}

TEST(Budget, TakesTheImportantAndThenTheQuickAsLongAsTheyFit) {
  const std::vector<StudySetting> settings = {of_samples(8, 1), of_samples(1, 1), of_samples(4, 0),
                                              of_samples(2, 0), of_samples(3, 1)};
  // 2 + 4 by rank, then 1 and 3; 8 does not fit. In the order of the plan.
  const BudgetChoice choice = choose_for_budget(settings, kCost, 1, 10);
  EXPECT_THAT(labels(choice.kept), ElementsAre("1", "4", "2", "3"));
  EXPECT_DOUBLE_EQ(choice.seconds, 10);
  ASSERT_EQ(choice.left_out.size(), 1u);
  EXPECT_EQ(choice.left_out[0].what, "samples: 8");
  EXPECT_THAT(choice.left_out[0].why, HasSubstr("8 s"));
}

TEST(Budget, RunsCount) {
  const std::vector<StudySetting> settings = {of_samples(2, 0), of_samples(4, 0)};
  EXPECT_THAT(labels(choose_for_budget(settings, kCost, 3, 10).kept), ElementsAre("2"));
}

TEST(Budget, ScenesOwnSettingIsAlwaysTaken) {
  const std::vector<StudySetting> settings = {of_samples(1, 0), of_samples(1000, 9, true)};
  EXPECT_THAT(labels(choose_for_budget(settings, kCost, 1, 0.5).kept), ElementsAre("1000"));
}

TEST(Budget, EnoughTimeLeavesNothingOut) {
  const std::vector<StudySetting> settings = {of_samples(1, 0), of_samples(64, 5)};
  const BudgetChoice choice = choose_for_budget(settings, kCost, 3, 1e6);
  EXPECT_EQ(choice.kept.size(), 2u);
  EXPECT_THAT(choice.left_out, IsEmpty());
}

TEST(Budget, PredictionKnowsShadowsAndScalarTypes) {
  const PilotCost cost{0.5, 0.1, 0.5, 4};
  StudySetting setting = of_samples(10, 0);
  EXPECT_DOUBLE_EQ(predicted_seconds(setting, cost), 1.5);
  setting.light_samples = 16;  // half of the rays become four times as many
  EXPECT_DOUBLE_EQ(predicted_seconds(setting, cost), 0.5 + 2.5);
  setting.light_samples.reset();
  setting.precision = render::Precision::quad;
  EXPECT_DOUBLE_EQ(predicted_seconds(setting, cost), 0.5 + kQuadFactor);
}

TEST(Budget, SharesAreAWhole) {
  for (const bool with_povray : {false, true}) {
    const TimeShares shares = time_shares(with_povray);
    EXPECT_NEAR(shares.references + shares.rounding + shares.sweep + shares.povray, 1, 1e-12);
    EXPECT_EQ(shares.povray > 0, with_povray);
  }
}

TEST(Budget, SamplesNearThoseOfTheReferenceAreLeftOut) {
  const std::vector<StudySetting> settings = {of_samples(16, 0), of_samples(64, 0),
                                              of_samples(128, 0), of_samples(1024, 0, true)};
  const BudgetChoice choice = within_reference(settings, 1024);
  EXPECT_THAT(labels(choice.kept), ElementsAre("16", "64", "1024"));
  ASSERT_EQ(choice.left_out.size(), 1u);
  EXPECT_THAT(choice.left_out[0].why, HasSubstr("1024"));
}

}  // namespace
}  // namespace alhazen
