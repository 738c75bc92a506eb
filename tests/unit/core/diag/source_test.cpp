#include "core/diag/source.h"

#include <gtest/gtest.h>

#include "core/diag/diagnostic.h"

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

// Around the marks of the index, and with characters of two bytes across them.
TEST(SourceManager, ColumnsOfALongLineAreCounted) {
  std::string text = "x\n";
  while (text.size() < 20000)
    text += "a\xc3\xb6";
  SourceManager sources;
  const FileId file = sources.add("a.scn", text);
  std::uint32_t column = 1;
  for (std::uint32_t i = 2; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (!begins) continue;
    EXPECT_EQ(sources.locate(file, i).column, column++) << i;
  }
}

TEST(DiagnosticSink, QuotesTheEndsOfLongTokens) {
  DiagnosticSink sink;
  const std::string token = std::string(100'000, '1') + "2";
  const Diagnostic& d = sink.report<DiagnosticKind::number_too_large>({}, token);
  EXPECT_EQ(d.message, "the number `" + std::string(36, '1') + "\u2026" + std::string(35, '1') +
                           "2` is too large");
  EXPECT_EQ(shorten_quotes("a long text without quotes " + token),
            "a long text without quotes " + token);
}

}  // namespace
}  // namespace alhazen
