// app/cli: a scene and its pictures, for verbs that hand both to another program.
#pragma once

#include <optional>
#include <vector>

#include "app/cli/render_request.h"
#include "app/cli/scene_options.h"
#include "render/color/color_config.h"

namespace alhazen {

struct SceneWithImages {
  LoadedScene loaded;
  std::vector<render::ImagePixels> images;  // parallel to Scene::images

  Scene& scene() { return *loaded.evaluation.scene; }
};

// Evaluates the scene, gives it `size` if there is one, and reads its pictures. A code means that
// the verb is over; complaints have gone to stderr.
std::optional<ExitCode> load_with_images(const SceneOptions& options,
                                         const render::ColorConfig& colors,
                                         const std::optional<PictureSize>& size,
                                         SceneWithImages& out);

}  // namespace alhazen
