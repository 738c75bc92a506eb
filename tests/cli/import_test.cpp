// tests/cli: alhazen import.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const char* const kNff =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 16 16\n"
    "l 1 2 9\nf 1 0.5 0.2 1 0 0 0 0\ns 0 0 0 1\np 4 -1 -1 0 1 -1 0 1 1 0 -1 1 0\n";

class Import : public ProgramTest {};

TEST_F(Import, WritesASceneInCanonicalLayoutAndSaysWhatItHolds) {
  write("a.nff", kNff);
  const Outcome outcome = run({"import", "a.nff", "-o", "a.scn"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "a.nff: 1 light, 1 material, 1 sphere, 1 polygon (2 triangles)\n");
  EXPECT_THAT(read("a.scn"), HasSubstr("sphere { center <0, 0, 0>  radius 1 }"));
  EXPECT_EQ(run({"fmt", "--check", "a.scn"}).code, 0);
  EXPECT_EQ(entries(), (std::vector<std::string>{"a.nff", "a.scn"}));
}

TEST_F(Import, WritesToStdout) {
  write("a.NFF", kNff);
  const Outcome outcome = run({"import", "a.NFF", "-o", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("#scn 1\n// a.NFF, in"));
}

TEST_F(Import, SaysWhatIsWrongAndWritesNothing) {
  write("a.nff", std::string(kNff) + "q\ns 0 0 one 1\n");
  const Outcome outcome = run({"import", "a.nff", "-o", "a.scn"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("a.nff:13:7: error: expected a number for the centre of `s`"));
  EXPECT_THAT(outcome.err, HasSubstr("a.nff:12:1: error: `q` is not an entity of NFF"));
  EXPECT_EQ(entries(), std::vector<std::string>{"a.nff"});
}

TEST_F(Import, CommandLine) {
  write("a.nff", kNff);
  write("a.obj", "v 1 2 3\n");
  EXPECT_EQ(run({"import", "a.nff"}).code, 2);
  EXPECT_EQ(run({"import", "a.obj", "-o", "a.scn"}).code, 2);
  EXPECT_EQ(run({"import", "missing.nff", "-o", "a.scn"}).code, 3);
  EXPECT_EQ(run({"import", "a.nff", "-o", "missing/a.scn"}).code, 3);
  EXPECT_EQ(run({"import", "a.nff", "-o", "a.nff"}).code, 2);
  EXPECT_EQ(read("a.nff"), kNff);
}

}  // namespace
}  // namespace alhazen::cli_test
