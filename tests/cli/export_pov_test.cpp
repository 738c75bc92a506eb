// tests/cli: alhazen export-pov.
#include <filesystem>
#include <gmock/gmock.h>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const char* const kExact =
    "#scn 1\nrender { size <40, 30> }\ncamera perspective { position <0, 0, -5> }\n"
    "light point { position <5, 5, -5> }\nsphere { material diffuse { } }\n";
const char* const kInexact =
    "#scn 1\ncamera perspective { position <0, 0, -5> }\nbackground rgb(1)\n"
    "sphere { material metal { preset gold } }\nsphere { center x*3  material coat { } }\n";

class ExportPov : public ProgramTest {
 protected:
  void copy_picture(const std::string& name) const {
    std::filesystem::copy_file(
        std::filesystem::path(ALHAZEN_SOURCE_DIR) / "scenes/feature/images/tiles.png",
        folder_ / name);
  }
};

TEST_F(ExportPov, WritesTheSceneAndNothingElse) {
  write("s.scn", kExact);
  const Outcome outcome = run({"export-pov", "s.scn", "-o", "s.pov"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(read("s.pov"), HasSubstr("#version 3.7;"));
  EXPECT_THAT(read("s.pov"), HasSubstr("+W40 +H30"));
  EXPECT_THAT(entries(), ElementsAre("s.pov", "s.scn"));
}

TEST_F(ExportPov, WritesToStdout) {
  write("s.scn", kExact);
  ASSERT_EQ(run({"export-pov", "s.scn", "-o", "scene.pov"}).code, 0);
  const Outcome outcome = run({"export-pov", "s.scn", "-o", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, read("scene.pov"));
  EXPECT_EQ(outcome.err, "");
}

TEST_F(ExportPov, NamesWhatIsNotExactByItsLine) {
  write("s.scn", kInexact);
  const Outcome outcome = run({"export-pov", "s.scn", "-o", "s.pov"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: Fresnel reflection of a metal: POV-Ray gets "));
  EXPECT_THAT(outcome.err, HasSubstr("(s.scn:5:31)"));
}

TEST_F(ExportPov, StrictRefusesThem) {
  write("s.scn", kInexact);
  const Outcome outcome = run({"export-pov", "s.scn", "-o", "s.pov", "--strict"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("(s.scn:4:19)"));
  EXPECT_THAT(outcome.err, HasSubstr("error: a diffuse base under a clear coat: "));
  EXPECT_THAT(entries(), ElementsAre("s.scn"));
  const Outcome piped = run({"export-pov", "s.scn", "-o", "-", "--strict"});
  EXPECT_EQ(piped.code, 2);
  EXPECT_EQ(piped.out, "");
  write("s.scn", kExact);
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", "s.pov", "--strict"}).code, 0);
}

TEST_F(ExportPov, TakesASizeAndParams) {
  write("s.scn",
        "#scn 1\nparam r = 1\ncamera perspective { position <0, 0, -5> }\n"
        "sphere { radius r  material diffuse { } }\n");
  const Outcome outcome =
      run({"export-pov", "s.scn", "-o", "-", "--size", "20x40", "-D", "r=0.625"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("+W20 +H40"));
  EXPECT_THAT(outcome.out, HasSubstr("up <0, 2, 0>"));
  EXPECT_THAT(outcome.out, HasSubstr("<0, 0, 0>, 0.625"));
}

TEST_F(ExportPov, PicturesGoBesideTheText) {
  copy_picture("tiles.png");
  write("s.scn", std::string(kExact) +
                     "plane { offset -1  material diffuse { color image(\"tiles.png\") } }\n");
  std::filesystem::create_directories(path("out"));
  const Outcome outcome = run({"export-pov", "s.scn", "-o", "out/a b\".pov"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(path("out/a b%22_0.exr")));
  EXPECT_THAT(read("out/a b\".pov"), HasSubstr("exr \"a b%22_0.exr\""));
  const Outcome piped = run({"export-pov", "s.scn", "-o", "-"});
  EXPECT_EQ(piped.code, 2);
  EXPECT_THAT(piped.err, HasSubstr("give -o a name"));
  EXPECT_EQ(piped.out, "");
}

TEST_F(ExportPov, WritesOverNoInput) {
  copy_picture("tiles.png");
  write("s.scn", std::string(kExact) +
                     "plane { offset -1  material diffuse { color "
                     "image(\"tiles.png\") } }\n");
  const std::string before = read("s.scn"), tiles = read("tiles.png");
  std::filesystem::create_symlink("s.scn", path("link.pov"));
  for (const char* const output : {"s.scn", "./s.scn", "link.pov", "tiles.png"}) {
    const Outcome outcome = run({"export-pov", "s.scn", "-o", output});
    EXPECT_EQ(outcome.code, 2) << output;
    EXPECT_THAT(outcome.err, HasSubstr("it is an input")) << output;
  }
  std::filesystem::create_symlink("tiles.png", path("p_0.exr"));
  const Outcome picture = run({"export-pov", "s.scn", "-o", "p.pov"});
  EXPECT_EQ(picture.code, 2);
  EXPECT_THAT(picture.err, HasSubstr("it is an input"));
  EXPECT_EQ(read("s.scn"), before);
  EXPECT_EQ(read("tiles.png"), tiles);
  EXPECT_FALSE(std::filesystem::exists(path("p.pov")));
}

TEST_F(ExportPov, CommandLine) {
  write("s.scn", kExact);
  write("wrong.scn", "#scn 1\nsphere { }\n");
  EXPECT_EQ(run({"export-pov", "none.scn", "-o", "s.pov"}).code, 3);
  EXPECT_EQ(run({"export-pov", "wrong.scn", "-o", "s.pov"}).code, 1);
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", "none/s.pov"}).code, 3);
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", "."}).code, 3);
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", ""}).code, 2);
  EXPECT_EQ(run({"export-pov", "s.scn"}).code, 2);
  EXPECT_EQ(run({"export-pov", "-o", "s.pov"}).code, 2);
  EXPECT_EQ(run({"export-pov", "s.scn", "s.scn", "-o", "s.pov"}).code, 2);
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", "s.pov", "--size", "0x3"}).code, 2);
  EXPECT_EQ(run({"export-pov", "s.scn", "-o", "s.pov", "-D", "none=1"}).code, 2);
  EXPECT_THAT(run({"export-pov", "s.scn", "-o", "s.pov", "--stict"}).err,
              HasSubstr("did you mean `--strict`?"));
  EXPECT_THAT(entries(), ElementsAre("s.scn", "wrong.scn"));
}

TEST_F(ExportPov, Help) {
  const Outcome outcome = run({"export-pov", "--help"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* const word : {"alhazen export-pov", "--strict", "--size", "-o", "POV-Ray 3.7"})
    EXPECT_THAT(outcome.out, HasSubstr(word));
}

TEST_F(ExportPov, AFullDiskOfStdoutIsAnIoError) {
  write("s.scn", kExact);
  RunOptions full{folder_};
  full.stdout_path = "/dev/full";
  EXPECT_EQ(run_alhazen({"export-pov", "s.scn", "-o", "-"}, full).code, 3);
}

}  // namespace
}  // namespace alhazen::cli_test
