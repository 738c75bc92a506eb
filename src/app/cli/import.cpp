// app/cli: alhazen import: a scene of another program as a .scn text.
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "app/cli/arguments.h"
#include "app/cli/load_scene.h"
#include "app/cli/overwrite_check.h"
#include "app/cli/streams.h"
#include "app/nff/read.h"
#include "app/nff/write_scn.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

std::string counted(std::size_t count, std::string_view thing, std::string_view things) {
  return fmt::format("{} {}", count, count == 1 ? thing : things);
}

std::string summary(const NffScene& scene) {
  const NffCounts& counts = scene.counts;
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, std::string_view thing, std::string_view things) {
    if (count > 0) parts.push_back(counted(count, thing, things));
  };
  add(scene.lights.size(), "light", "lights");
  add(scene.fills.size(), "material", "materials");
  add(counts.spheres, "sphere", "spheres");
  add(counts.cones, "cone or cylinder", "cones and cylinders");
  add(counts.polygons, "polygon", "polygons");
  add(counts.patches, "patch", "patches");
  std::string text = fmt::format("{}", fmt::join(parts, ", "));
  if (counts.polygons + counts.patches > 0) {
    text += fmt::format(" ({})", counted(counts.triangles, "triangle", "triangles"));
  }
  return parts.empty() ? "nothing to see" : text;
}

bool is_nff(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".nff";
}

ExitCode write_scene(const std::string& text, const std::string& output) {
  if (output == "-") return print(text);
  const Status written = write_file_atomic(output, text);
  return written ? ExitCode::done : report(written.error());
}

ExitCode import_nff(const std::string& input, const std::string& output) {
  const std::uint64_t most_bytes = parser::EvalLimits{}.source_bytes;
  Result<std::string> text = read_file(input, most_bytes);
  if (!text) return report(text.error());
  SourceManager sources;
  DiagnosticSink sink;
  const FileId file = sources.add(input, std::move(text).value());
  const std::optional<NffScene> scene = read_nff(file, sources, sink);
  show_diagnostics(sink, sources);
  if (!scene) return exit_code(sink.code());

  const std::string scn = write_scn(*scene, std::filesystem::path(input).filename().string());
  if (scn.size() > most_bytes) {
    return report({ErrorCode::limit,
                   fmt::format("`{}` would make a scene of {} bytes, but one has at most {}; "
                               "import it in parts",
                               input, scn.size(), most_bytes)});
  }
  const ExitCode code = write_scene(scn, output);
  if (code == ExitCode::done) write_stderr(fmt::format("{}: {}\n", input, summary(*scene)));
  return code;
}

}  // namespace

ExitCode run_import(const Arguments& arguments) {
  CommandLine line("import",
                   "Writes the scene of a file in Haines's Neutral File Format (.nff) as a .scn "
                   "text.\ndocs/nff.md says what becomes of what.",
                   "  alhazen import balls.nff -o balls.scn\n"
                   "  alhazen import balls.nff -o - | head\n");
  std::string input, output;
  line.add_option("FILE", input, "the .nff file")->required()->type_name("");
  line.text_option("-o,--output", "FILE", output, "the scene to write; `-` for stdout")->required();
  if (const auto code = line.read(arguments)) return *code;
  if (!is_nff(input)) {
    return line.complain(
        fmt::format("`{}` does not end in `.nff`; only Haines's Neutral File "
                    "Format can be imported",
                    input));
  }
  if (const Status status = check_overwrites({output}, {input}); !status) {
    return report(status.error());
  }
  return import_nff(input, output);
}

}  // namespace alhazen
