// tests/cli: check, fmt, explain and dump on a scene that is right.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Forms : public ProgramTest {
 protected:
  Forms() { write("s.scn", kSmallScene); }
};

TEST_F(Forms, CheckFindsNothing) {
  const Outcome outcome = run({"check", "s.scn"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("no mistakes: 3 shapes, 1 light,"));
  const Outcome json = run({"check", "s.scn", "--format", "json"});
  EXPECT_EQ(json.code, 0);
  EXPECT_EQ(nlohmann::json::parse(json.out).at("errors"), 0);
}

TEST_F(Forms, FmtIsIdempotentAndKeepsTheScene) {
  write("s.scn", std::string(kSmallScene) + "// a comment\nsphere{center<0,0,9> radius 1}\n");
  const std::string before = run({"dump", "s.scn", "--scene"}).out;
  EXPECT_EQ(run({"fmt", "s.scn", "--check"}).code, 1);
  EXPECT_EQ(run({"fmt", "s.scn"}).code, 0);
  EXPECT_EQ(run({"fmt", "s.scn", "--check"}).code, 0);
  const std::string once = read("s.scn");
  EXPECT_THAT(once, HasSubstr("// a comment"));
  EXPECT_EQ(run({"fmt", "s.scn"}).code, 0);
  EXPECT_EQ(read("s.scn"), once);
  EXPECT_EQ(run({"dump", "s.scn", "--scene"}).out, before);
}

TEST_F(Forms, FmtLeavesWhatDoesNotParseAndGoesOn) {
  write("bad.scn", "#scn 1\nsphere {\n");
  write("good.scn", "#scn 1\nsphere   {  radius   1 }\n");
  EXPECT_EQ(run({"fmt", "bad.scn", "good.scn"}).code, 1);
  EXPECT_EQ(read("bad.scn"), "#scn 1\nsphere {\n");
  EXPECT_EQ(read("good.scn"), "#scn 1\nsphere { radius 1 }\n");
}

TEST_F(Forms, FmtKeepsLinksAndPermissions) {
  write("good.scn", "#scn 1\nsphere   {  radius   1 }\n");
  const auto mode = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(folder_ / "good.scn", mode);
  std::filesystem::create_symlink("good.scn", folder_ / "link.scn");
  EXPECT_EQ(run({"fmt", "link.scn"}).code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.scn"));
  EXPECT_EQ(std::filesystem::status(folder_ / "good.scn").permissions(), mode);
  EXPECT_EQ(read("good.scn"), "#scn 1\nsphere { radius 1 }\n");
}

TEST_F(Forms, ExplainNamesEffectsAndTheLinesThatCallForThem) {
  const Outcome text = run({"explain", "s.scn"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("s.scn:"));
  const auto json = nlohmann::json::parse(run({"explain", "s.scn", "--json"}).out);
  EXPECT_FALSE(json.at("effects").empty());
  EXPECT_FALSE(json.at("stages").empty());
}

TEST_F(Forms, EveryDumpPrintsSomethingElse) {
  std::vector<std::string> seen;
  for (const char* form : {"--tokens", "--ast", "--scene", "--plan"}) {
    const Outcome outcome = run({"dump", "s.scn", form});
    EXPECT_EQ(outcome.code, 0) << form << outcome.err;
    EXPECT_THAT(outcome.out, Not(IsEmpty()));
    EXPECT_THAT(seen, Not(testing::Contains(outcome.out)));
    seen.push_back(outcome.out);
  }
}

TEST_F(Forms, DumpWantsExactlyOneForm) {
  EXPECT_EQ(run({"dump", "s.scn"}).code, 2);
  EXPECT_EQ(run({"dump", "s.scn", "--ast", "--scene"}).code, 2);
}

TEST_F(Forms, EveryVerbHasHelpWithExamples) {
  for (const char* verb : {"render", "check", "fmt", "explain", "dump", "compare"}) {
    const Outcome outcome = run({verb, "--help"});
    EXPECT_EQ(outcome.code, 0) << verb;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr(std::string("alhazen ") + verb));
    EXPECT_THAT(outcome.out, HasSubstr("Examples:"));
    EXPECT_EQ(outcome.out, run({"help", verb}).out);
    for (std::size_t begin = 0; begin < outcome.out.size();) {
      const std::size_t end = outcome.out.find('\n', begin);
      EXPECT_LE(end - begin, 100u) << outcome.out.substr(begin, end - begin);
      begin = end + 1;
    }
  }
}

}  // namespace
}  // namespace alhazen::cli_test
