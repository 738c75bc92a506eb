// tests/hard/pictures: the scenes of tools/hard-table say something.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "support/front_end.h"

namespace alhazen::hard {
namespace {

TEST(Hard, ScenesAreWellFormed) {
  namespace fs = std::filesystem;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(ALHAZEN_SOURCE_DIR) / "scenes/hard")) {
    if (entry.path().extension() != ".scn") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const test::FrontEnd checked =
        test::check(entry.path().filename().string(), text.str(), entry.path().parent_path());
    EXPECT_EQ(checked.errors(), "") << entry.path();
    // A heading says which case it is and what is to be seen.
    EXPECT_NE(text.str().find("Expected:"), std::string::npos) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 20);
}

}  // namespace
}  // namespace alhazen::hard
