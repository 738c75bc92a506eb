#include "core/diag/source.h"

#include <gtest/gtest.h>

namespace alhazen {
namespace {

TEST(SourceManager, CountsLinesAndCodePoints) {
  SourceManager sources;
  const FileId file = sources.add("a.scn", "one\nzw\xc3\xb6lf x\r\nlast");
  EXPECT_EQ(sources.describe({file, 0, 1}), "a.scn:1:1");
  EXPECT_EQ(sources.describe({file, 10, 11}), "a.scn:2:6");  // the two bytes of ö are one column
  EXPECT_EQ(sources.line_text(file, 2), "zw\xc3\xb6lf x");
  EXPECT_EQ(sources.line_text(file, 3), "last");
  EXPECT_EQ(sources.describe({}), "");
}

TEST(SourceManager, EndOfTextIsAPlace) {
  SourceManager sources;
  const FileId file = sources.add("a.scn", "x\n");
  EXPECT_EQ(sources.describe({file, 2, 2}), "a.scn:2:1");
  EXPECT_EQ(sources.line_text(file, 2), "");
}

}  // namespace
}  // namespace alhazen
