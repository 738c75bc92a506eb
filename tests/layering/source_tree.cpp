#include "layering/source_tree.h"

#include <algorithm>
#include <regex>

#include "core/base/file.h"

namespace alhazen::layering {

std::string room_of(std::string_view path) {
  const std::size_t side = path.find('/');
  const std::size_t room = side == path.npos ? path.npos : path.find('/', side + 1);
  return room == path.npos ? "" : std::string(path.substr(0, room));
}

std::string SourceFile::room() const {
  return path.starts_with("src/") ? room_of(std::string_view(path).substr(4)) : "";
}

std::size_t SourceFile::lines() const {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::vector<SourceFile> source_files(const std::filesystem::path& folder) {
  const std::filesystem::path root = ALHAZEN_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp" && extension != ".def") continue;
    SourceFile file{std::filesystem::relative(entry.path(), root).string(),
                    read_file(entry.path(), 1 << 24).value(),
                    {}};
    file.code = strip_comments_and_literals(file.text);
    files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<Include> includes(const SourceFile& file) {
  static const std::regex line(R"((?:^|\n)[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"])");
  std::vector<Include> found;
  for (std::sregex_iterator it(file.text.begin(), file.text.end(), line), end; it != end; ++it) {
    found.push_back({(*it)[2], (*it)[1] == "<"});
  }
  return found;
}

namespace {

// The offset just after the comment or literal that begins at `i`, or `i` if none does.
std::size_t skip(const std::string& text, std::size_t i) {
  const auto after = [&](const std::string& closer, std::size_t from) {
    const std::size_t at = text.find(closer, from);
    return at == std::string::npos ? text.size() : at + closer.size();
  };
  if (text.compare(i, 2, "//") == 0) return std::min(text.find('\n', i), text.size());
  if (text.compare(i, 2, "/*") == 0) return after("*/", i + 2);
  if (text.compare(i, 2, "R\"") == 0) {
    const std::size_t open = text.find('(', i);
    return after(")" + text.substr(i + 2, open - i - 2) + "\"", open);
  }
  const bool digit_separator = i > 0 && std::isxdigit(static_cast<unsigned char>(text[i - 1])) != 0;
  if (text[i] == '"' || (text[i] == '\'' && !digit_separator)) {
    std::size_t j = i + 1;
    while (j < text.size() && text[j] != text[i])
      j += text[j] == '\\' ? 2 : 1;
    return std::min(j + 1, text.size());
  }
  return i;
}

}  // namespace

std::string strip_comments_and_literals(const std::string& text) {
  std::string code;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t next = skip(text, i);
    if (next == i) {
      code += text[i++];
      continue;
    }
    code += ' ';
    code.append(static_cast<std::size_t>(std::count(text.begin() + static_cast<long>(i),
                                                    text.begin() + static_cast<long>(next), '\n')),
                '\n');
    i = next;
  }
  return code;
}

}  // namespace alhazen::layering
