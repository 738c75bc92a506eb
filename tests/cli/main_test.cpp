// tests/cli: the program without a scene: verbs, help, versions, streams.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::HasSubstr;
using Main = ProgramTest;

TEST_F(Main, NoVerbIsAUsageError) {
  const Outcome outcome = run({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("alhazen --help"));
}

TEST_F(Main, MisspeltVerbIsAnsweredWithTheRightOne) {
  const Outcome outcome = run({"versoin"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean `version`?"));
}

TEST_F(Main, SceneWithoutAVerbIsAnsweredWithTheWholeCommand) {
  EXPECT_THAT(run({"a.scn"}).err, HasSubstr("alhazen render a.scn"));
}

TEST_F(Main, HelpGoesToStdoutAndListsEveryVerb) {
  for (const char* word : {"--help", "-h", "help"}) {
    const Outcome outcome = run({word});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("  version "));
  }
}

TEST_F(Main, MisspeltOptionIsAnsweredWithTheRightOne) {
  const Outcome outcome = run({"--version", "--jsno"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean `--json`?"));
  EXPECT_THAT(outcome.err, HasSubstr("--help"));
}

TEST_F(Main, VersionNamesItselfAndItsLibraries) {
  const Outcome text = run({"--version"});
  EXPECT_EQ(text.code, 0);
  EXPECT_THAT(text.out, testing::StartsWith("alhazen "));
  const auto json = nlohmann::json::parse(run({"--version", "--json"}).out);
  EXPECT_EQ("alhazen " + json.at("version").get<std::string>(),
            text.out.substr(0, text.out.find('\n')));
  EXPECT_FALSE(json.at("compiler").get<std::string>().empty());
  for (const auto& library : json.at("libraries")) {
    EXPECT_THAT(text.out, HasSubstr(library.at("name").get<std::string>()));
  }
}

TEST_F(Main, FullDiskUnderStdoutIsAnIoError) {
  RunOptions options;
  options.stdout_path = "/dev/full";
  const Outcome outcome = run_alhazen({"--version"}, options);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("standard output"));
}

}  // namespace
}  // namespace alhazen::cli_test
