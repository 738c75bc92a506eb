// parser/eval: paths. Nothing here opens a file.
#include "parser/eval/files.h"

#include <algorithm>
#include <system_error>

namespace alhazen::parser {
namespace {

bool is_below(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  static_cast<void>(ignored);
  return end == folder.end();
}

}  // namespace

std::optional<std::filesystem::path> resolve_file(Context& context, SourceSpan at,
                                                  const std::string& name) {
  if (context.options().files == FileAccess::none) {
    context.report<DiagnosticKind::files_not_available>(at, name);
    return std::nullopt;
  }
  if (name.empty() || name.find('\0') != std::string::npos) {
    context.report<DiagnosticKind::unreadable_file>(at, name, "not a file name");
    return std::nullopt;
  }
  std::error_code error;
  const std::filesystem::path wanted = context.folder_of(at.file) / name;
  const std::filesystem::path path = std::filesystem::canonical(wanted, error);
  // The rule first: what lies outside is not even said to exist.
  const auto plain = error ? std::filesystem::weakly_canonical(wanted, error) : path;
  if (context.options().files == FileAccess::below_scene && !is_below(plain, context.root())) {
    context.report<DiagnosticKind::file_outside>(at, name).hint(
        "copy the file there, or allow it with `--allow-outside` if you trust the scene");
    return std::nullopt;
  }
  if (path.empty() || !std::filesystem::exists(path, error)) {
    context.report<DiagnosticKind::unreadable_file>(at, name, "no such file");
    return std::nullopt;
  }
  if (!std::filesystem::is_regular_file(path, error)) {
    context.report<DiagnosticKind::unreadable_file>(at, name, "not a file");
    return std::nullopt;
  }
  return path;
}

}  // namespace alhazen::parser
