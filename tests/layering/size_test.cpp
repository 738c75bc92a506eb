// tests/layering: no file is a hall. Tables (.def) may be as long as what they list.
#include <algorithm>
#include <gtest/gtest.h>

#include "layering/source_tree.h"

namespace alhazen::layering {
namespace {

std::vector<std::size_t> sorted_sizes(const char* folder) {
  std::vector<std::size_t> sizes;
  for (const SourceFile& file : source_files(folder)) {
    if (!file.path.ends_with(".def")) sizes.push_back(file.lines());
  }
  std::ranges::sort(sizes);
  return sizes;
}

class Sizes : public testing::TestWithParam<const char*> {};

TEST_P(Sizes, NoFileIsOver500Lines) {
  for (const SourceFile& file : source_files(GetParam())) {
    if (file.path.ends_with(".def")) continue;
    EXPECT_LE(file.lines(), 500u) << file.path;
  }
}

TEST_P(Sizes, HalfTheFilesAreUnder150LinesAndNineInTenUnder350) {
  const std::vector<std::size_t> sizes = sorted_sizes(GetParam());
  ASSERT_FALSE(sizes.empty());
  EXPECT_LE(sizes[sizes.size() / 2], 150u);
  EXPECT_LE(sizes[sizes.size() * 9 / 10], 350u);
}

INSTANTIATE_TEST_SUITE_P(Folders, Sizes, testing::Values("src", "tests"),
                         [](const auto& folder) { return std::string(folder.param); });

}  // namespace
}  // namespace alhazen::layering
