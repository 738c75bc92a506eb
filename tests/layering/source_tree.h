// tests/layering: the source files as text, for tests that read the code itself.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alhazen::layering {

// "core/base" of "core/base/file.h": its first two folders; "" for a path that has fewer.
std::string room_of(std::string_view path);

struct SourceFile {
  std::string path;  // from the root of the repository: "src/core/base/file.h"
  std::string text;
  std::string code;  // `text` with comments blanked out and string literals emptied

  bool is_header() const { return path.ends_with(".h"); }
  std::string room() const;
  std::size_t lines() const;
};

// Every .h, .cpp and .def file below `folder`, sorted by path.
std::vector<SourceFile> source_files(const std::filesystem::path& folder);

// What stands between the quotes or angle brackets of each #include.
struct Include {
  std::string target;
  bool system;  // <...>
};
std::vector<Include> includes(const SourceFile& file);

// `text` without comments and with empty string and character literals; line breaks stay.
std::string strip_comments_and_literals(const std::string& text);

}  // namespace alhazen::layering
