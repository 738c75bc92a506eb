#include "core/diag/source.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace alhazen {
namespace {

// Whether the byte is not a continuation byte of UTF-8.
bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace

FileId SourceManager::add(std::string name, std::string text) {
  File file{std::move(name), std::move(text), {0}, {}};
  const std::string_view all = file.text;
  std::uint32_t points = 0;
  for (std::size_t i = 0; i < all.size(); i += kStride) {
    file.points.push_back(points);
    const std::string_view part = all.substr(i, kStride);
    points += static_cast<std::uint32_t>(std::count_if(part.begin(), part.end(), begins_character));
  }
  for (std::size_t i = all.find('\n'); i != std::string_view::npos; i = all.find('\n', i + 1))
    file.line_starts.push_back(static_cast<std::uint32_t>(i + 1));
  files_.push_back(std::move(file));
  return static_cast<FileId>(files_.size() - 1);
}

std::uint32_t SourceManager::points_before(const File& file, std::uint32_t offset) {
  if (file.points.empty()) return 0;
  const std::size_t end = std::min<std::size_t>(offset, file.text.size());
  const std::size_t mark = std::min(end / kStride, file.points.size() - 1);
  const auto begin = file.text.begin();
  const auto beyond_mark =
      std::count_if(begin + static_cast<std::ptrdiff_t>(mark * kStride),
                    begin + static_cast<std::ptrdiff_t>(end), begins_character);
  return file.points[mark] + static_cast<std::uint32_t>(beyond_mark);
}

LineColumn SourceManager::locate(FileId file, std::uint32_t offset) const {
  const auto& starts = files_[file].line_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - starts.begin());
  const std::uint32_t before = points_before(files_[file], starts[line - 1]);
  return {line, points_before(files_[file], offset) - before + 1};
}

std::string_view SourceManager::line_text(FileId file, std::uint32_t line) const {
  const File& source = files_[file];
  const std::uint32_t begin = source.line_starts[line - 1];
  std::size_t end =
      line < source.line_starts.size() ? source.line_starts[line] - 1 : source.text.size();
  if (end > begin && source.text[end - 1] == '\r') --end;
  return std::string_view(source.text).substr(begin, end - begin);
}

std::string SourceManager::describe(SourceSpan span) const {
  if (!span.known()) return "";
  const LineColumn at = locate(span.file, span.begin);
  return fmt::format("{}:{}:{}", name(span.file), at.line, at.column);
}

}  // namespace alhazen
