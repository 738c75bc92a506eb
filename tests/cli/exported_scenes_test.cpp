// tests/cli: POV-Ray reads what export-pov writes of every scene that there is to look at.
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cli/program.h"
#include "cli/witness.h"

namespace alhazen::cli_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const char* const folder : {"scenes/feature", "scenes/gallery"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(ALHAZEN_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".scn") names.push_back(folder / entry.path().filename());
    }
  }
  std::ranges::sort(names);
  return names;
}

class ExportedScenes : public ProgramTest, public testing::WithParamInterface<std::string> {};

TEST_P(ExportedScenes, PovRayReadsThem) {
  const Outcome exported = run(
      {"export-pov", fs::path(ALHAZEN_SOURCE_DIR) / GetParam(), "-o", "s.pov", "--size", "16x12"});
  ASSERT_EQ(exported.code, 0) << exported.err;
  if (!is_installed("povray")) {
    GTEST_SKIP() << "POV-Ray is not installed: exported, but not read (apt install povray)";
  }
  EXPECT_TRUE(run_shell(
      folder_,
      "povray +Is.pov +Os.exr +FE +W16 +H12 -D -V -A -J > log 2>&1 || { cat log; false; }"));
  EXPECT_TRUE(fs::exists(path("s.exr")));
}

std::string name_of(const testing::TestParamInfo<std::string>& scene) {
  return fs::path(scene.param).stem();
}

INSTANTIATE_TEST_SUITE_P(All, ExportedScenes, testing::ValuesIn(scenes()), name_of);

}  // namespace
}  // namespace alhazen::cli_test
