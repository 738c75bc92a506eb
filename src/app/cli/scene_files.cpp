#include "app/cli/scene_files.h"

#include "render/color/color_config.h"

namespace alhazen {

std::vector<std::filesystem::path> files_used(const parser::Evaluation& evaluation,
                                              const std::string& color_file) {
  std::vector<std::filesystem::path> files = evaluation.files_read;
  for (const ImageFile& image : evaluation.scene->images)
    files.emplace_back(image.path);
  const render::ColorSource colors = render::color_source(color_file);
  for (const std::string& file : {colors.explicit_file, colors.environment_file}) {
    if (!file.empty()) files.emplace_back(file);
  }
  return files;
}

}  // namespace alhazen
