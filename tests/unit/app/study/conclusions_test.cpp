#include "app/study/conclusions.h"

#include <gmock/gmock.h>

#include "unit/app/study/studies.h"

namespace alhazen {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Conclusions, FrontLeavesOutWhatIsBeatenAndWhatCannotBeShown) {
  EXPECT_THAT(front_of(small_study(), false), ElementsAre(0, 1, 2, 3));
}

TEST(Conclusions, SayWhenEverythingIsWithinAStep) {
  EXPECT_THAT(conclusions(small_study()),
              Contains(HasSubstr("Within 1/255 everywhere from 640 ms of CPU time (64 samples)")));
}

TEST(Conclusions, SayWhatIsNearestWhenNothingIs) {
  SceneStudy study = small_study();
  for (StudyPoint& point : study.points)
    point.errors.pixels_over = 5;
  study.points[3].errors.pixels_over = 1;
  const std::string first = conclusions(study).front();
  EXPECT_THAT(first, HasSubstr("No setting here is within 1/255 everywhere"));
  EXPECT_THAT(first, HasSubstr("1 % of the pixels"));
  EXPECT_THAT(first, HasSubstr("In 99 % of the pixels it is, from 640 ms"));
}

TEST(Conclusions, SayWhatTheScenesOwnSettingsGive) {
  EXPECT_THAT(conclusions(small_study()),
              Contains(HasSubstr("own settings (16 samples, depth 16, cutoff 1/512, box) take "
                                 "160 ms and give an RMSE of 0.0025")));
}

TEST(Conclusions, SayWhatHalvingCosts) {
  // The next point that shows at most half of it is four times as dear.
  EXPECT_THAT(conclusions(small_study()),
              Contains(HasSubstr("Halving the error from here costs 4 times the time")));
  EXPECT_DOUBLE_EQ(halving_cost(small_study()).value(), 4);
  SceneStudy study = small_study();
  study.points.erase(study.points.begin() + 3);
  EXPECT_THAT(conclusions(study), Contains(HasSubstr("reached by no setting")));
  EXPECT_FALSE(halving_cost(study));
}

TEST(Conclusions, SayTheSlope) {
  EXPECT_THAT(conclusions(small_study()), Contains(HasSubstr("to the power of \u22121.00")));
}

TEST(Conclusions, SayWhichDepthIsEnough) {
  SceneStudy study = small_study();
  for (const int depth : {1, 2, 4, 8}) {
    StudyPoint point = point_of(Knob::depth, 16, 0.1, 0.01);
    point.setting.settings.max_depth = depth;
    point.truncation_rmse = 0.001 / (depth * depth);  // 0.0025 / 10 from 2 on
    study.points.push_back(point);
  }
  ASSERT_NE(enough(study, Knob::depth, 0.0025), nullptr);
  EXPECT_EQ(enough(study, Knob::depth, 0.0025)->setting.settings.max_depth, 2);
  EXPECT_EQ(enough(study, Knob::depth, 1e-9), nullptr);
  EXPECT_THAT(conclusions(study), Contains(HasSubstr("a depth of 2 is enough")));
}

TEST(Conclusions, EqualErrorIsTheRatioOfTheFronts) {
  const auto rows = equal_errors(study_with_povray());
  ASSERT_EQ(rows.size(), std::size(kEqualErrors));
  for (const EqualError& row : rows)
    EXPECT_NEAR(row.ratio().value(), 3, 1e-9) << row.rmse;
  for (const EqualError& row : equal_errors(small_study()))
    EXPECT_FALSE(row.ratio());
  EXPECT_THAT(conclusions(study_with_povray()),
              Contains(HasSubstr("POV-Ray takes 3 times as long")));
}

TEST(Conclusions, RoundingTellsTheGain) {
  SceneStudy study = small_study();
  RoundingPoint in_float{render::Precision::float32, {}, {}}, in_double;
  in_float.errors.rmse = 1e-5;
  in_double.errors.rmse = 1e-14;
  study.rounding = RoundingStudy{4, {in_float, in_double, {render::Precision::quad, {}, {}}}};
  EXPECT_NEAR(study.rounding->gain().value(), 1e9, 1);
  EXPECT_THAT(conclusions(study), Contains(HasSubstr("times less")));
  study.rounding->points[1].errors.rmse = 0;
  EXPECT_FALSE(study.rounding->gain());
  EXPECT_THAT(conclusions(study), Contains(HasSubstr("and not at all in double")));
}

TEST(Conclusions, AreSentences) {
  EXPECT_THAT(conclusions(study_with_povray()), Each(EndsWith(".")));
}

}  // namespace
}  // namespace alhazen
