#include "app/cli/scene_with_images.h"

#include "app/cli/load_images.h"

namespace alhazen {

std::optional<ExitCode> load_with_images(const SceneOptions& options,
                                         const render::ColorConfig& colors,
                                         const std::optional<PictureSize>& size,
                                         SceneWithImages& out) {
  if (const auto code = load_scene(options, out.loaded)) return code;
  if (size) {
    out.scene().settings.width = size->width;
    out.scene().settings.height = size->height;
  }
  DiagnosticSink errors;
  out.images = load_images(out.scene(), colors, errors).pixels;
  show_diagnostics(errors, out.loaded.sources);
  if (errors.error_count() > 0) return exit_code(errors.code());
  return std::nullopt;
}

}  // namespace alhazen
