// tests/cli: alhazen study, on pictures so small that it takes no time.
#include <csignal>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const char* const kScene =
    "#scn 1\nrender { size <8, 6>  samples 4 }\ncamera perspective { position <0, 0, -5> }\n"
    "background rgb(0.5)\nsphere { material glow { color rgb(0.9, 0.5, 0.1) } }\n";

class Study : public ProgramTest {
 protected:
  Study() {
    write("a.scn", kScene);
    write("b.scn", kScene);
  }
  Outcome study(std::vector<std::string> words) const {
    words.insert(words.begin(), "study");
    words.insert(words.end(), {"--budget", "1", "--runs", "1", "--progress", "none"});
    return run(words);
  }
};

TEST_F(Study, OneSceneGivesAPageItsFiguresAndATable) {
  const Outcome outcome = study({"a.scn", "-o", "out"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("a: 8 \u00d7 6 pixels"));
  EXPECT_THAT(outcome.out, HasSubstr("Pareto front"));
  EXPECT_THAT(read("out/a.html"), HasSubstr("<svg"));
  EXPECT_THAT(read("out/a.csv"), HasSubstr("scene,curve,settings"));
  EXPECT_EQ(nlohmann::json::parse(read("out/a.json"))["scene"], "a");
  EXPECT_THAT(entries(), ElementsAre("a.scn", "b.scn", "out"));
}

TEST_F(Study, SeveralScenesGiveAnIndex) {
  const Outcome outcome = study({"a.scn", "b.scn", "-o", "out", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).size(), 2u);
  EXPECT_THAT(read("out/index.html"), HasSubstr("href=\"b.html\""));
}

TEST_F(Study, ScenesOfOneNameHaveTheirOwnFiles) {
  EXPECT_EQ(study({"a.scn", "./a.scn", "-o", "out"}).code, 0);
  EXPECT_EQ(nlohmann::json::parse(read("out/a-2.json"))["scene"], "a-2");
}

TEST_F(Study, PovRayThatIsNotThereIsToldOnThePage) {
  const Outcome outcome =
      study({"a.scn", "-o", "out", "--povray", "--povray-program", "/nowhere/povray"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(read("out/a.html"), HasSubstr("POV-Ray is needed"));
}

TEST_F(Study, WrongWordsAreUsageErrors) {
  EXPECT_EQ(run({"study", "a.scn"}).code, 2);
  EXPECT_EQ(run({"study", "-o", "out"}).code, 2);
  EXPECT_EQ(run({"study", "a.scn", "-o", "out", "--budget", "0"}).code, 2);
  EXPECT_EQ(run({"study", "a.scn", "-o", "out", "--progress", "json"}).code, 2);
}

TEST_F(Study, SceneThatIsWrongAndFolderThatCannotBeHaveTheirCodes) {
  write("wrong.scn", "#scn 1\nsphere { radius }\n");
  EXPECT_EQ(study({"wrong.scn", "-o", "out"}).code, 1);
  EXPECT_EQ(study({"nowhere.scn", "-o", "out"}).code, 3);
  EXPECT_EQ(study({"a.scn", "-o", "a.scn"}).code, 3);
}

TEST_F(Study, PageIsNotWrittenOverWhatASceneIsReadFrom) {
  write("x.html", kScene);
  const Outcome outcome = study({"x.html", "-o", "."});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would be written over"));
  EXPECT_EQ(read("x.html"), kScene);
}

TEST_F(Study, StopsWithItsCodeAndLeavesNoHalfPage) {
  for (const int number : {SIGINT, SIGTERM}) {
    RunOptions options;
    options.folder = folder_;
    options.send_signal = number;
    options.signal_after = "about";
    const Outcome outcome = run_alhazen(
        {"study", "a.scn", "-o", "out", "--size", "64x48", "--budget", "1000"}, options);
    EXPECT_EQ(outcome.code, 75) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(path("out")));
  }
}

}  // namespace
}  // namespace alhazen::cli_test
