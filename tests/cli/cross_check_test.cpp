// tests/cli: alhazen cross-check, mostly with programs that stand in for POV-Ray.
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/witness.h"

namespace alhazen::cli_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string scene(const std::string& color) {
  return "#scn 1\nrender { size <16, 12>  samples 1 }\ncamera perspective { position <0, 0, -5> }\n"
         "background " +
         color + "\nsphere { material diffuse { } }\n";
}

// Temporary files go to `tmp` in the test's folder, so that it is seen whether they are removed.
class CrossCheck : public ProgramTest {
 protected:
  CrossCheck() {
    fs::create_directories(path("tmp"));
    ::setenv("TMPDIR", path("tmp").c_str(), 1);
    write("s.scn", scene("rgb(0.5)"));
    write("other.scn", scene("rgb(0.25)"));
    for (const char* const name : {"s", "other"}) {
      const std::string file = std::string(name) + ".scn",
                        picture = path(std::string(name) + ".exr");
      EXPECT_EQ(run({"render", file, "-q", "--samples", "1", "-o", picture}).code, 0);
    }
    fake("povray-same", copies("s.exr"));
    fake("povray-other", copies("other.exr"));
  }
  ~CrossCheck() override {
    EXPECT_TRUE(fs::is_empty(path("tmp"))) << "temporary files are left";
    ::unsetenv("TMPDIR");
  }

  void fake(const std::string& name, const std::string& script) const {
    fs::permissions(write(name, "#!/bin/sh\n" + script), fs::perms::owner_all);
  }
  // A program that takes a picture for its own.
  std::string copies(const std::string& picture) const {
    return "for w in \"$@\"; do case $w in +O*) out=${w#+O}; out=${out#?}; out=${out%?};; esac; "
           "done\n"
           "cp '" +
           path(picture) + "' \"$out\"\n";
  }
  Outcome check(std::vector<std::string> words, const std::string& povray = "same") const {
    words.insert(words.begin(), "cross-check");
    words.insert(words.end(), {"--povray", "./povray-" + povray});
    return run(words);
  }
};

TEST_F(CrossCheck, TheSamePictureIsTheSame) {
  const Outcome outcome = check({"s.scn"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("1 of 1 scenes are the same"));
  EXPECT_THAT(entries(), Not(testing::Contains("s.pov")));
}

TEST_F(CrossCheck, AnotherPictureIsDifferent) {
  const Outcome outcome = check({"s.scn", "other.scn"}, "other");
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("DIFFERENT"));
  EXPECT_THAT(outcome.err, HasSubstr("1 of 2 scenes are the same"));
}

TEST_F(CrossCheck, JsonIsAllOfStdout) {
  const Outcome outcome = check({"s.scn", "other.scn", "none.scn", "--json"}, "other");
  EXPECT_EQ(outcome.code, 3);
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["scenes"].size(), 3U);
  EXPECT_EQ(json["scenes"][0]["scene"], "s");
  EXPECT_EQ(json["scenes"][0]["same"], false);
  EXPECT_EQ(json["scenes"][0]["witnesses"][0]["channels"], 16 * 12 * 3);
  EXPECT_EQ(json["scenes"][1]["same"], true);
  EXPECT_EQ(json["scenes"][2]["same"], false);
  EXPECT_TRUE(json["scenes"][2].contains("error"));
}

TEST_F(CrossCheck, TheReportHasAPageDataAndAllFiles) {
  const Outcome outcome = check({"s.scn", "--report", "a/report"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path("a/report")))
    names.push_back(entry.path().filename());
  EXPECT_THAT(names, testing::UnorderedElementsAre("index.html", "results.json", "s.exr", "s.pov",
                                                   "s.povray.exr"));
  EXPECT_EQ(nlohmann::json::parse(read("a/report/results.json"))["scenes"].size(), 1U);
  EXPECT_THAT(read("a/report/index.html"),
              AllOf(HasSubstr("<!DOCTYPE html>"), HasSubstr("id=\"s\"")));
  EXPECT_EQ(read("a/report/s.povray.exr"), read("s.exr"));
}

TEST_F(CrossCheck, AFailedSceneIsInTheReport) {
  write("wrong.scn", "#scn 1\nsphere { }\n");
  const Outcome outcome = check({"wrong.scn", "s.scn", "--report", "r"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("wrong.scn:1"), HasSubstr("1 could not be compared")));
  EXPECT_THAT(read("r/index.html"), HasSubstr("FAILED"));
}

TEST_F(CrossCheck, AToleranceIsUsedForItsSceneOnly) {
  write("expected.json", R"({"s.scn": {"rmse": 10, "reason": "a test"}})");
  EXPECT_EQ(check({"s.scn"}, "other").code, 0);
  EXPECT_THAT(check({"s.scn"}, "other").err, HasSubstr("a test"));
  write("expected.json", R"({"other.scn": {"rmse": 10, "reason": "a test"}})");
  EXPECT_EQ(check({"s.scn"}, "other").code, 5);
  write("more.json", R"({"s.scn": {"rmse": 1e-6, "reason": "a test"}})");
  EXPECT_EQ(check({"s.scn", "--expect", "more.json"}, "other").code, 5);
  EXPECT_EQ(check({"s.scn", "--expect", "more.json"}).code, 0);
  EXPECT_EQ(check({"s.scn", "--expect", "none.json"}).code, 3);
}

TEST_F(CrossCheck, ABrokenFileOfTolerancesIsNamed) {
  write("expected.json", R"({"s.scn": {"rmse": -1, "reason": "a test"}})");
  const Outcome outcome = check({"s.scn"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("expected.json"), HasSubstr("`s.scn`")));
}

TEST_F(CrossCheck, AToleranceOfNoSceneIsAnError) {
  write("expected.json", R"({"sc.scn": {"rmse": 1, "reason": "misspelt"}})");
  const Outcome outcome = check({"s.scn"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("expected.json"), HasSubstr("no scene `sc.scn`")));
}

// A file beside the scene is a second witness, unless we wrote it ourselves or it is not wanted.
TEST_F(CrossCheck, OnlyWhatWasWrittenByHandIsASecondWitness) {
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", "s.pov"}).code, 0);
  EXPECT_THAT(check({"s.scn"}).err, Not(HasSubstr("(by hand)")));
  write("s.pov", "// mine\n");
  EXPECT_THAT(check({"s.scn"}).err, HasSubstr("(by hand)"));
  EXPECT_THAT(check({"s.scn", "--exported-only"}).err, Not(HasSubstr("(by hand)")));
}

// Where the two cutoffs work differently there is none on either side; else the scene's stays.
TEST_F(CrossCheck, ACutoffThatWorksDifferentlyIsLeftOut) {
  const std::string head =
      "#scn 1\nrender { size <16, 12>  cutoff 0.25 }\n"
      "camera perspective { position <0, 0, -5> }\nsphere { material mirror { ";
  write("grey.scn", head + "color rgb(0.5) } }\n");
  write("red.scn", head + "color rgb(0.5, 0.25, 0.25) } }\n");
  check({"grey.scn", "red.scn", "--report", "r"});
  EXPECT_THAT(read("r/grey.pov"), HasSubstr("adc_bailout 0.25\n"));
  EXPECT_THAT(read("r/red.pov"), HasSubstr("adc_bailout 0\n"));
}

// Two folders, and a scene called as the second of two.
TEST_F(CrossCheck, ScenesOfOneNameDoNotShareFiles) {
  for (const char* const folder : {"a", "b", "c"})
    fs::create_directories(path(folder));
  write("a/s.scn", scene("rgb(0.5)"));
  write("b/s.scn", scene("rgb(0.25)"));
  write("c/s-2.scn", scene("rgb(0.125)"));
  const Outcome outcome = check({"a/s.scn", "b/s.scn", "c/s-2.scn", "--report", "r", "--json"});
  EXPECT_EQ(outcome.code, 5);
  const auto json = nlohmann::json::parse(outcome.out);
  std::vector<std::string> names;
  for (const auto& entry : json["scenes"])
    names.push_back(entry["scene"]);
  EXPECT_THAT(names, ElementsAre("s", "s-2", "s-2-2"));
  EXPECT_THAT(read("r/s.pov"), HasSubstr("rgb 0.5"));
  EXPECT_THAT(read("r/s-2.pov"), HasSubstr("rgb 0.25"));
  EXPECT_THAT(read("r/s-2-2.pov"), HasSubstr("rgb 0.125"));
}

TEST_F(CrossCheck, TheReportWritesOverNoInput) {
  write("s.pov", "by hand");
  const std::string before = read("s.pov");
  const Outcome outcome = check({"s.scn", "--report", "."});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("s.pov"), HasSubstr("it is an input")));
  EXPECT_EQ(read("s.pov"), before);
}

TEST_F(CrossCheck, WhatPovRayRefusesIsShown) {
  fake("povray-bad", "echo 'Parse Error: no such thing'; exit 1");
  const Outcome outcome = check({"s.scn", "other.scn"}, "bad");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("Parse Error: no such thing"), HasSubstr("2 could not be compared")));
}

TEST_F(CrossCheck, APictureOfAnotherSizeIsAnIoError) {
  const Outcome outcome = check({"s.scn", "--size", "20x10"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("has 16 x 12 pixels, not 20 x 10"));
  fake("povray-text", copies("s.scn"));
  EXPECT_EQ(check({"s.scn"}, "text").code, 3);
}

TEST_F(CrossCheck, WithoutPovRayNothingGoesOn) {
  const Outcome outcome = run({"cross-check", "s.scn", "other.scn", "--povray", "/nonexistent"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("/nonexistent"), HasSubstr("apt install povray")));
  EXPECT_THAT(outcome.err, Not(HasSubstr("scenes are the same")));
}

TEST_F(CrossCheck, ItMayTakeSoLong) {
  fake("povray-slow", "sleep 100");
  const Outcome outcome = check({"s.scn", "--time-limit", "1"}, "slow");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("more than 1 seconds"));
}

TEST_F(CrossCheck, ASignalEndsItAndLeavesNothing) {
  for (const char* const name : {"INT", "TERM"}) {
    fake("povray-slow",
         fmt::format("kill -{} $PPID; echo $$ > '{}'; exec sleep 100", name, path("pid")));
    const Outcome outcome = check({"s.scn", "other.scn"}, "slow");
    EXPECT_EQ(outcome.code, 75) << name;
    EXPECT_THAT(outcome.err, HasSubstr("stopped"));
    EXPECT_FALSE(run_shell(folder_, "kill -0 $(cat pid) 2> /dev/null")) << "POV-Ray goes on";
  }
}

TEST_F(CrossCheck, AParentThatIgnoresItsChildrenIsNoObstacle) {
  EXPECT_TRUE(run_shell(folder_, fmt::format("trap '' CHLD; '{}' cross-check s.scn --povray "
                                             "./povray-same 2> log || {{ cat log; false; }}",
                                             ALHAZEN_PROGRAM)));
}

TEST_F(CrossCheck, NoPlaceForTemporaryFilesIsSaid) {
  ::setenv("TMPDIR", path("none").c_str(), 1);
  const Outcome outcome = check({"s.scn"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("TMPDIR"));
}

TEST_F(CrossCheck, CommandLine) {
  EXPECT_EQ(check({}).code, 2);
  EXPECT_EQ(check({"none.scn"}).code, 3);
  EXPECT_EQ(check({"s.scn", "--report", "s.exr"}).code, 3);
  EXPECT_EQ(check({"s.scn", "--report", "/proc/none"}).code, 3);
  EXPECT_EQ(check({"s.scn", "--size", "0x1"}).code, 2);
  EXPECT_EQ(check({"s.scn", "--threads", "0"}).code, 2);
  EXPECT_EQ(check({"s.scn", "--time-limit", "-1"}).code, 2);
  EXPECT_EQ(check({"s.scn", "-D", "none=1"}).code, 2);
  EXPECT_THAT(check({"s.scn", "--reprot", "r"}).err, HasSubstr("did you mean `--report`?"));
  const Outcome help = run({"cross-check", "--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* const word : {"alhazen cross-check", "--report", "--povray", "expected.json"})
    EXPECT_THAT(help.out, HasSubstr(word));
}

TEST_F(CrossCheck, WithPovRayItself) {
  if (!is_installed("povray")) {
    GTEST_SKIP() << "POV-Ray is not installed: nothing was compared with it (apt install povray)";
  }
  fs::create_directories(path("a b;\"'\n"));
  write("a b;\"'\n/\u00fc \"x\".scn", scene("rgb(0.5)"));
  const Outcome outcome =
      run({"cross-check", "a b;\"'\n/\u00fc \"x\".scn", "--report", "r \u00fc"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  write("s.pov",
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
        "camera { location <0, 0, -5> direction z right x up y }\nbackground { rgb 0.9 }\n");
  const Outcome by_hand = run({"cross-check", "s.scn"});
  EXPECT_EQ(by_hand.code, 5);
  EXPECT_THAT(by_hand.err, HasSubstr("s (by hand)"));
  EXPECT_THAT(by_hand.err, HasSubstr("s (exported): all channels agree"));
}

}  // namespace
}  // namespace alhazen::cli_test
