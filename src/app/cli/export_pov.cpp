// app/cli: alhazen export-pov: a scene as POV-Ray text, and what of it is not exact.
#include "app/povray/export_pov.h"

#include <filesystem>
#include <fmt/format.h>

#include "app/cli/overwrite_check.h"
#include "app/cli/render_values.h"
#include "app/cli/scene_files.h"
#include "app/cli/scene_with_images.h"
#include "app/cli/streams.h"
#include "core/base/file.h"

namespace alhazen {
namespace {

struct ExportOptions {
  SceneOptions scene;
  std::string output;
  std::optional<PictureSize> size;
  bool strict = false;
};

std::vector<std::string> output_names(const PovExport& exported,
                                      const std::filesystem::path& output) {
  std::vector<std::string> names = {output.string()};
  for (const PovFile& file : exported.files)
    names.push_back((output.parent_path() / file.name).string());
  return names;
}

Status write_files(const PovExport& exported, const std::filesystem::path& output) {
  for (const PovFile& file : exported.files) {
    const Status written = write_file_atomic(output.parent_path() / file.name, file.bytes);
    if (!written) return written;
  }
  return write_file_atomic(output, exported.text);
}

// Refuses with --strict; otherwise says what is not the same.
bool accepts(const ExportOptions& options, const PovExport& exported,
             const SourceManager& sources) {
  std::string text;
  for (const std::string& deviation : deviation_texts(exported.deviations, sources)) {
    text += fmt::format("{}: {}\n", options.strict ? "error" : "note", deviation);
  }
  write_stderr(text);
  return !options.strict || exported.deviations.empty();
}

}  // namespace

ExitCode run_export_pov(const Arguments& arguments) {
  CommandLine line(
      "export-pov",
      "Writes the equivalent scene for POV-Ray 3.7. What POV-Ray cannot say exactly is "
      "written as its nearest equivalent and named on stderr.",
      "  alhazen export-pov scene.scn -o scene.pov\n"
      "  alhazen export-pov scene.scn -o - --strict | less\n");
  ExportOptions options;
  add_scene_options(line, options.scene);
  line.text_option("-o,--output", "OUT.pov", options.output,
                   "the file to write; pictures that the scene uses go beside it; - is stdout")
      ->required();
  line.value_option("--size", "WxH", options.size, to_size,
                    "width and height of the picture [the scene's]");
  line.flag("--strict", options.strict, "refuse a scene that POV-Ray cannot say exactly");
  if (const auto code = line.read(arguments)) return *code;

  const auto colors = render::ColorConfig::open(render::color_source(options.scene.color_file));
  if (!colors) return report(colors.error());
  SceneWithImages input;
  if (const auto code = load_with_images(options.scene, colors.value(), options.size, input)) {
    return *code;
  }
  const std::filesystem::path output = options.output;
  const std::string stem = options.output == "-" ? "scene" : output.stem().string();
  const SourceManager& sources = input.loaded.sources;
  const auto exported = export_pov(input.scene(), sources, input.images, stem);
  if (!exported) return report(exported.error());
  if (!accepts(options, exported.value(), sources)) return ExitCode::usage;
  if (options.output == "-") {
    if (!exported.value().files.empty()) {
      return line.complain("the scene uses pictures, which need files: give -o a name");
    }
    return print(exported.value().text);
  }
  const auto inputs = files_used(input.loaded.evaluation, options.scene.color_file);
  const Status apart = check_overwrites(output_names(exported.value(), output), inputs);
  if (!apart) return report(apart.error());
  const Status written = write_files(exported.value(), output);
  return written ? ExitCode::done : report(written.error());
}

}  // namespace alhazen
