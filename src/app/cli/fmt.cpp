// app/cli: alhazen fmt: scenes in the canonical layout.
#include <filesystem>
#include <fmt/format.h>

#include "app/cli/arguments.h"
#include "app/cli/load_scene.h"
#include "app/cli/streams.h"
#include "core/base/file.h"
#include "parser/parse/parse.h"
#include "parser/print/format.h"

namespace alhazen {
namespace {

// The text in canonical layout if the code is done; otherwise its mistakes are on stderr.
struct Formatted {
  ExitCode code;
  std::string text;
};

Formatted formatted(const std::string& name, const std::string& text) {
  SourceManager sources;
  DiagnosticSink sink;
  const FileId file = sources.add(name, text);
  const ast::File tree = parser::parse(file, sources, sink);
  show_diagnostics(sink, sources);
  if (sink.error_count() > 0) return {exit_code(sink.code()), ""};
  return {ExitCode::done, parser::format(tree, sources)};
}

// A symbolic link stays one, and the file keeps its permissions.
Status replace_file(const std::string& path, const std::string& text) {
  std::error_code failure;
  const std::filesystem::path target = std::filesystem::canonical(path, failure);
  if (failure) return Error{ErrorCode::io, fmt::format("cannot write `{}`", path)};
  const auto permissions = std::filesystem::status(target, failure).permissions();
  if (Status written = write_file_atomic(target, text); !written) return written;
  std::filesystem::permissions(target, permissions, failure);
  return Unit{};
}

ExitCode format_file(const std::string& path, bool check_only) {
  const Result<std::string> text = read_file(path, parser::EvalLimits{}.source_bytes);
  if (!text) return report(text.error());
  const Formatted result = formatted(path, text.value());
  if (result.code != ExitCode::done || result.text == text.value()) return result.code;
  if (check_only) {
    write_stderr(fmt::format("{}: is not in canonical layout\n", path));
    return ExitCode::scene_wrong;
  }
  const Status written = replace_file(path, result.text);
  return written ? ExitCode::done : report(written.error());
}

}  // namespace

ExitCode run_fmt(const Arguments& arguments) {
  CommandLine line("fmt",
                   "Rewrites scenes in the canonical layout, in place, without a copy of what was\n"
                   "there. Comments stay, and so does the meaning; a scene that does not parse is\n"
                   "left alone.",
                   "  alhazen fmt scene.scn\n"
                   "  alhazen fmt --check scenes/*.scn     for a build server: exit code 1 if any\n"
                   "                                       file would change\n");
  std::vector<std::string> paths;
  bool check_only = false;
  line.scene_arguments(paths);
  line.flag("--check", check_only, "change nothing, say which files would change");
  if (const auto code = line.read(arguments)) return *code;
  // One bad file does not keep the others from being done; the first failure decides.
  ExitCode first = ExitCode::done;
  for (const std::string& path : paths) {
    const ExitCode code = format_file(path, check_only);
    if (first == ExitCode::done) first = code;
  }
  return first;
}

}  // namespace alhazen
