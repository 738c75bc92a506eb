// core/diag: the texts a run has read, and places in them.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace alhazen {

using FileId = std::uint32_t;
inline constexpr FileId kNoFile = ~FileId{0};

// Bytes [begin, end) of a file. The default span is "nowhere" (command line, built-in values).
struct SourceSpan {
  FileId file = kNoFile;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  bool known() const { return file != kNoFile; }
  friend bool operator==(const SourceSpan&, const SourceSpan&) = default;
};

// From the beginning of `first` to the end of `last`; both lie in one file.
inline SourceSpan join(SourceSpan first, SourceSpan last) {
  return {first.file, first.begin, last.end};
}

// Line and column count from 1; the column counts code points of UTF-8, as editors do.
struct LineColumn {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

// Owns every text. Views into a text stay valid for the life of the manager.
class SourceManager {
 public:
  // `name` is what messages show. Precondition: text.size() < 2^32 - 1.
  FileId add(std::string name, std::string text);

  const std::string& name(FileId file) const { return files_[file].name; }
  std::string_view text(FileId file) const { return files_[file].text; }
  std::string_view text(SourceSpan span) const {
    return text(span.file).substr(span.begin, span.end - span.begin);
  }
  std::size_t size() const { return files_.size(); }

  LineColumn locate(FileId file, std::uint32_t offset) const;
  // The line with this number, without its line break.
  std::string_view line_text(FileId file, std::uint32_t line) const;
  // "name:line:column" of the beginning of a span, or "" for nowhere.
  std::string describe(SourceSpan span) const;

 private:
  struct File {
    std::string name;
    std::string text;
    std::vector<std::uint32_t> line_starts;
    std::vector<std::uint32_t> points;  // code points before byte 0, kStride, 2 kStride, ...
  };
  static constexpr std::uint32_t kStride = 4096;
  // Code points before byte `offset`, in constant time: a line can be as long as its file.
  static std::uint32_t points_before(const File& file, std::uint32_t offset);

  std::deque<File> files_;
};

}  // namespace alhazen
