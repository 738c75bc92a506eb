// tests/cli: scenes that cannot be used: each gives its exit code and says why, and no verb leaves
// a file behind.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Case {
  const char* name;
  int code;
};

// The files that the cases are about, in the test's folder.
// gtest would print the bytes of the struct.
void PrintTo(const Case& scene, std::ostream* out) {
  *out << scene.name;
}

class ReadScene : public ProgramTest, public testing::WithParamInterface<Case> {
 protected:
  ReadScene() {
    write("empty.scn", "");
    write("blank.scn", "  \n\n");
    write("binary.scn", std::string("\x7f"
                                    "ELF\0\1\2\xff",
                                    8));
    write("foreign.scn", "scene.camera.type = \"perspective\"\n");
    write("unfinished.scn", "#scn 1\nsphere { center <0,");
    write("several.scn", "#scn 1\nspere { }\nsphere { radius -1 }\n");
    write("loop.scn", "#scn 1\nlet n = 0\nfor i in 0 .. 1000000000 { let m = i * 2 }\n");
    write("include_itself.scn", "#scn 1\ninclude \"include_itself.scn\"\n");
    write("outside.scn", "#scn 1\ninclude \"../elsewhere.scn\"\n");
    std::filesystem::create_directories(folder_ / "folder.scn");
    // 100 MB of which the disk holds nothing.
    write("huge.scn", "#scn 1\n");
    std::filesystem::resize_file(folder_ / "huge.scn", 100'000'000);
  }
};

TEST_P(ReadScene, EveryVerbGivesItsCodeAndSaysWhy) {
  const std::string scene = GetParam().name;
  const std::vector<std::string> before = entries();
  for (const std::vector<std::string>& words : {std::vector<std::string>{"check", scene},
                                                {"render", scene, "-o", "out.exr"},
                                                {"explain", scene},
                                                {"dump", scene, "--scene"}}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.signal, 0) << words[0];
    EXPECT_EQ(outcome.code, GetParam().code) << words[0] << ": " << outcome.err;
    EXPECT_THAT(outcome.err, Not(IsEmpty()));
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(entries(), before);
}

TEST_P(ReadScene, CheckTellsItAsJson) {
  const Outcome outcome = run({"check", GetParam().name, "--format", "json"});
  EXPECT_EQ(outcome.code, GetParam().code);
  EXPECT_EQ(outcome.err, "");
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_GE(json.at("errors"), 1);
  EXPECT_FALSE(json.at("diagnostics").empty());
}

INSTANTIATE_TEST_SUITE_P(Files, ReadScene,
                         testing::Values(Case{"missing.scn", 3}, Case{"folder.scn", 3},
                                         Case{"empty.scn", 1}, Case{"blank.scn", 1},
                                         Case{"binary.scn", 1}, Case{"foreign.scn", 1},
                                         Case{"unfinished.scn", 1}, Case{"several.scn", 1},
                                         Case{"include_itself.scn", 1}, Case{"outside.scn", 1},
                                         Case{"loop.scn", 4}, Case{"huge.scn", 4}),
                         [](const auto& test) {
                           const std::string name = test.param.name;
                           return name.substr(0, name.find('.'));
                         });

using Defines = ProgramTest;

TEST_F(Defines, MisspeltNameIsAUsageErrorWithTheRightOne) {
  write("s.scn", kSmallScene);
  const Outcome outcome = run({"check", "s.scn", "-D", "bal_ior=1.3"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("ball_ior"));
}

TEST_F(Defines, ValueOutOfItsRangeOrOfAnotherTypeIsAnError) {
  write("s.scn", kSmallScene);
  for (const char* define :
       {"ball_ior=7", "ball_ior=\"glass\"", "ball_ior=1 +", "ball_ior=1e400"}) {
    const Outcome outcome = run({"check", "s.scn", "-D", define});
    EXPECT_THAT(outcome.code, testing::AnyOf(1, 2)) << define;
    EXPECT_THAT(outcome.err, Not(IsEmpty()));
  }
}

TEST_F(Defines, SeveralAreTakenAndTheSceneAfterThem) {
  write("s.scn", kSmallScene);
  const Outcome outcome =
      run({"dump", "-D", "ball_ior=1.25", "--define", "frame=3", "s.scn", "--scene"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1.25"));
}

TEST_F(Defines, NoEqualsSignIsAUsageError) {
  write("s.scn", kSmallScene);
  const Outcome outcome = run({"check", "s.scn", "-D", "ball_ior"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("NAME=VALUE"));
}

}  // namespace
}  // namespace alhazen::cli_test
