#include "app/cli/scene_options.h"

#include "app/cli/render_values.h"
#include "app/cli/streams.h"

namespace alhazen {

void add_scene_options(CommandLine& line, SceneOptions& options) {
  line.scene_argument(options.scene);
  line.list_option("-D,--define", "NAME=VALUE", options.defines, to_define,
                   "another value for a `param` of the scene; may be repeated");
  line.flag("--allow-outside", options.allow_outside,
            "let the scene read files outside of the folder it stands in");
  line.text_option("--ocio", "FILE", options.color_file,
                   "OpenColorIO configuration [$OCIO, or else a built-in one]");
}

void add_format_options(CommandLine& line, std::string_view text_goes, bool& as_json) {
  const auto is_json = [](const std::string& text) -> Result<bool> {
    if (text == "text" || text == "json") return text == "json";
    return Error{ErrorCode::usage, fmt::format("expected text or json, found `{}`", text)};
  };
  line.value_option("--format", "FORMAT", as_json, is_json,
                    fmt::format("text on {} [default], or json on stdout", text_goes));
  line.add_flag_callback(
          "--json", [&as_json] { as_json = true; }, "the same as --format json")
      ->group("Options");
}

Result<parser::EvalOptions> eval_options(const SceneOptions& options) {
  const auto colors = render::ColorConfig::open(render::color_source(options.color_file));
  if (!colors) return colors.error();
  return eval_options(
      colors.value(), options.defines,
      options.allow_outside ? parser::FileAccess::anywhere : parser::FileAccess::below_scene);
}

std::optional<ExitCode> load_scene(const SceneOptions& options, LoadedScene& loaded) {
  const auto eval = eval_options(options);
  if (!eval) return report(eval.error());
  return load_scene(options.scene, eval.value(), loaded);
}

}  // namespace alhazen
