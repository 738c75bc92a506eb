// tests/cli: the scene that the README shows is the one that its first command renders.
#include <gtest/gtest.h>

#include "core/base/file.h"

namespace alhazen::cli_test {
namespace {

std::string text_of(const std::string& path) {
  return read_file(std::string(ALHAZEN_SOURCE_DIR) + "/" + path, 1 << 20).value();
}

// Each line indented as Markdown wants it.
std::string as_code_block(const std::string& text) {
  std::string block;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    if (end > begin + 1) block += "    ";
    block += text.substr(begin, end - begin);
    begin = end;
  }
  return block;
}

TEST(Readme, ShowsTheSceneThatItRenders) {
  const std::string readme = text_of("README.md");
  EXPECT_NE(readme.find("\n" + as_code_block(text_of("scenes/first.scn"))), std::string::npos);
  EXPECT_NE(text_of("tools/render-first-scene").find("render scenes/first.scn"), std::string::npos);
}

}  // namespace
}  // namespace alhazen::cli_test
